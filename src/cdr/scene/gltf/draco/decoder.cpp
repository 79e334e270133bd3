#include "decoder.h"

#include "../checks.h"
#include "guard.h"

#include <draco/compression/attributes/linear_sequencer.h>
#include <draco/compression/attributes/sequential_attribute_decoders_controller.h>
#include <draco/compression/attributes/sequential_quantization_attribute_decoder.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/compression/mesh/traverser/depth_first_traverser.h>
#include <draco/compression/mesh/traverser/max_prediction_degree_traverser.h>
#include <draco/compression/mesh/traverser/mesh_attribute_indices_encoding_observer.h>
#include <draco/compression/mesh/traverser/mesh_traversal_sequencer.h>

#include <exception>
#include <utility>

namespace cdr::scene::gltf {

namespace {

/// Predicts texture coordinates as another scheme does, except for a number of flags beyond the mesh's corners.
class GuardedScheme final : public draco::PredictionSchemeTypedDecoderInterface<std::int32_t> {
  public:
    using Scheme = draco::PredictionSchemeTypedDecoderInterface<std::int32_t>;

    GuardedScheme(std::unique_ptr<Scheme> scheme, DracoGuard& guard)
        : m_scheme(std::move(scheme)),
          m_guard(guard) {}

    bool DecodePredictionData(draco::DecoderBuffer* buffer) override {
        // No stream of 2.2 has the older scheme.
        return GetPredictionMethod() == draco::MESH_PREDICTION_TEX_COORDS_PORTABLE &&
               m_guard.allowsFlags(*buffer) && m_scheme->DecodePredictionData(buffer);
    }
    bool ComputeOriginalValues(const std::int32_t* corrections, std::int32_t* values, int size,
                               int components, const draco::PointIndex* points) override {
        return m_scheme->ComputeOriginalValues(corrections, values, size, components, points);
    }
    draco::PredictionSchemeMethod GetPredictionMethod() const override {
        return m_scheme->GetPredictionMethod();
    }
    const draco::PointAttribute* GetAttribute() const override { return m_scheme->GetAttribute(); }
    bool IsInitialized() const override { return m_scheme->IsInitialized(); }
    int GetNumParentAttributes() const override { return m_scheme->GetNumParentAttributes(); }
    draco::GeometryAttribute::Type GetParentAttributeType(int i) const override {
        return m_scheme->GetParentAttributeType(i);
    }
    bool SetParentAttribute(const draco::PointAttribute* attribute) override {
        return m_scheme->SetParentAttribute(attribute);
    }
    bool AreCorrectionsPositive() override { return m_scheme->AreCorrectionsPositive(); }
    draco::PredictionSchemeTransformType GetTransformType() const override {
        return m_scheme->GetTransformType();
    }

  private:
    std::unique_ptr<Scheme> m_scheme;
    DracoGuard& m_guard;
};

/// Decodes numbers as `Base` does, except for tables beyond those of an encoder.
template <typename Base>
class GuardedNumbers final : public Base {
  public:
    explicit GuardedNumbers(DracoGuard& guard) : m_guard(guard) {}

    bool DecodePortableAttribute(const std::vector<draco::PointIndex>& points,
                                 draco::DecoderBuffer* buffer) override {
        return m_guard.allowsNumbers(*buffer) && Base::DecodePortableAttribute(points, buffer);
    }

  protected:
    std::unique_ptr<GuardedScheme::Scheme>
    CreateIntPredictionScheme(draco::PredictionSchemeMethod method,
                              draco::PredictionSchemeTransformType transform) override {
        std::unique_ptr<GuardedScheme::Scheme> scheme = Base::CreateIntPredictionScheme(method, transform);
        if (scheme == nullptr || (method != draco::MESH_PREDICTION_TEX_COORDS_DEPRECATED &&
                                  method != draco::MESH_PREDICTION_TEX_COORDS_PORTABLE)) {
            return scheme;
        }
        return std::make_unique<GuardedScheme>(std::move(scheme), m_guard);
    }

  private:
    DracoGuard& m_guard;
};

/// The same of normals, around libdraco's decoder of them: its header cannot be included, since distributions leave out others
/// that it needs. Nothing is predicted from normals, so nobody asks for what is in the other decoder.
class GuardedNormals final : public draco::SequentialAttributeDecoder {
  public:
    GuardedNormals(std::unique_ptr<draco::SequentialAttributeDecoder> decoder, DracoGuard& guard)
        : m_decoder(std::move(decoder)),
          m_guard(guard) {}

    bool Init(draco::PointCloudDecoder* decoder, int attribute) override {
        return SequentialAttributeDecoder::Init(decoder, attribute) && m_decoder != nullptr &&
               m_decoder->Init(decoder, attribute);
    }
    bool DecodePortableAttribute(const std::vector<draco::PointIndex>& points,
                                 draco::DecoderBuffer* buffer) override {
        return m_guard.allowsNumbers(*buffer) && m_decoder->DecodePortableAttribute(points, buffer);
    }
    bool DecodeDataNeededByPortableTransform(const std::vector<draco::PointIndex>& points,
                                             draco::DecoderBuffer* buffer) override {
        return m_decoder->DecodeDataNeededByPortableTransform(points, buffer);
    }
    bool TransformAttributeToOriginalFormat(const std::vector<draco::PointIndex>& points) override {
        return m_decoder->TransformAttributeToOriginalFormat(points);
    }

  private:
    std::unique_ptr<draco::SequentialAttributeDecoder> m_decoder;
    DracoGuard& m_guard;
};

/// The order in which edgebreaker keeps the values of a group of attributes. Which table of corners it follows is known only
/// when the attributes are.
class EdgebreakerOrder final : public draco::PointsSequencer {
  public:
    enum class Kind { vertices, verticesByDegree, corners };

    EdgebreakerOrder(const draco::MeshEdgebreakerDecoder& decoder, Kind kind)
        : m_decoder(decoder),
          m_kind(kind) {}

    bool UpdatePointToAttributeIndexMapping(draco::PointAttribute* attribute) override {
        return m_order != nullptr && m_order->UpdatePointToAttributeIndexMapping(attribute);
    }
    /// One of the group.
    void setAttribute(int attribute) { m_attribute = attribute; }

  protected:
    bool GenerateSequenceInternal() override {
        using draco::CornerTable;
        using draco::MeshAttributeCornerTable;
        using Observer = draco::MeshAttributeIndicesEncodingObserver<CornerTable>;
        using CornerObserver = draco::MeshAttributeIndicesEncodingObserver<MeshAttributeCornerTable>;
        if (m_kind == Kind::corners) {
            m_order = follow<draco::DepthFirstTraverser<MeshAttributeCornerTable, CornerObserver>>(
                m_decoder.GetAttributeCornerTable(m_attribute));
        } else if (m_kind == Kind::verticesByDegree) {
            m_order = follow<draco::MaxPredictionDegreeTraverser<CornerTable, Observer>>(
                m_decoder.GetCornerTable());
        } else {
            m_order = follow<draco::DepthFirstTraverser<CornerTable, Observer>>(m_decoder.GetCornerTable());
        }
        return m_order != nullptr && m_order->GenerateSequence(out_point_ids());
    }

  private:
    template <typename Traverser>
    std::unique_ptr<draco::PointsSequencer> follow(const typename Traverser::CornerTable* corners) const {
        if (corners == nullptr) {
            return nullptr;
        }
        // The decoder fills it in here, and its predictions read it.
        auto* places = const_cast<draco::MeshAttributeIndicesEncodingData*>(
            m_decoder.GetAttributeEncodingData(m_attribute));
        auto order = std::make_unique<draco::MeshTraversalSequencer<Traverser>>(m_decoder.mesh(), places);
        Traverser traverser;
        traverser.Init(corners,
                       typename Traverser::TraversalObserver(corners, m_decoder.mesh(), order.get(), places));
        order->SetTraverser(traverser);
        return order;
    }

    const draco::MeshEdgebreakerDecoder& m_decoder;
    Kind m_kind;
    int m_attribute = -1;
    std::unique_ptr<draco::PointsSequencer> m_order;
};

/// Decodes a group of attributes by decoders that are guarded.
class GuardedAttributes final : public draco::SequentialAttributeDecodersController {
  public:
    /// @param edgebreaker what `order` holds if it is one, else null
    GuardedAttributes(std::unique_ptr<draco::PointsSequencer> order, EdgebreakerOrder* edgebreaker,
                      DracoGuard& guard)
        : SequentialAttributeDecodersController(std::move(order)),
          m_guard(guard),
          m_order(edgebreaker) {}

    bool DecodeAttributesDecoderData(draco::DecoderBuffer* buffer) override {
        if (!m_guard.allowsAttributes(*buffer) ||
            !SequentialAttributeDecodersController::DecodeAttributesDecoderData(buffer)) {
            return false;
        }
        if (m_order != nullptr) {
            m_order->setAttribute(GetAttributeId(0));
        }
        return true;
    }

  protected:
    std::unique_ptr<draco::SequentialAttributeDecoder> CreateSequentialDecoder(std::uint8_t kind) override {
        switch (kind) {
        case draco::SEQUENTIAL_ATTRIBUTE_ENCODER_GENERIC:
            return std::make_unique<draco::SequentialAttributeDecoder>();
        case draco::SEQUENTIAL_ATTRIBUTE_ENCODER_INTEGER:
            return std::make_unique<GuardedNumbers<draco::SequentialIntegerAttributeDecoder>>(m_guard);
        case draco::SEQUENTIAL_ATTRIBUTE_ENCODER_QUANTIZATION:
            return std::make_unique<GuardedNumbers<draco::SequentialQuantizationAttributeDecoder>>(m_guard);
        case draco::SEQUENTIAL_ATTRIBUTE_ENCODER_NORMALS:
            return std::make_unique<GuardedNormals>(
                SequentialAttributeDecodersController::CreateSequentialDecoder(kind), m_guard);
        default:
            return nullptr;
        }
    }

  private:
    DracoGuard& m_guard;
    EdgebreakerOrder* m_order; ///< the base class owns it
};

/// A mesh decoder whose attributes are guarded.
template <typename Base>
class GuardedMesh : public Base {
  public:
    explicit GuardedMesh(DracoGuard& guard) : m_guard(guard) {}

  protected:
    bool DecodeAllAttributes() override {
        return m_guard.allowsValues(*this->point_cloud()) && Base::DecodeAllAttributes();
    }
    bool addGroup(int id, std::unique_ptr<draco::PointsSequencer> order, EdgebreakerOrder* edgebreaker) {
        return this->SetAttributesDecoder(
            id, std::make_unique<GuardedAttributes>(std::move(order), edgebreaker, m_guard));
    }

  private:
    DracoGuard& m_guard;
};

class GuardedSequential final : public GuardedMesh<draco::MeshSequentialDecoder> {
  public:
    using GuardedMesh::GuardedMesh;

  protected:
    bool CreateAttributesDecoder(std::int32_t id) override {
        const auto vertices = static_cast<std::int32_t>(point_cloud()->num_points());
        return addGroup(id, std::make_unique<draco::LinearSequencer>(vertices), nullptr);
    }
};

class GuardedEdgebreaker final : public GuardedMesh<draco::MeshEdgebreakerDecoder> {
  public:
    using GuardedMesh::GuardedMesh;

  protected:
    bool CreateAttributesDecoder(std::int32_t id) override {
        draco::DecoderBuffer ahead = *buffer();
        std::int8_t table = 0;
        std::uint8_t kind = 0;
        std::uint8_t traversal = 0;
        // The decoder checks them, and notes which table the group has; its own decoder of the group is replaced.
        if (!ahead.Decode(&table) || !ahead.Decode(&kind) || !ahead.Decode(&traversal) ||
            !MeshEdgebreakerDecoder::CreateAttributesDecoder(id)) {
            return false;
        }
        using Kind = EdgebreakerOrder::Kind;
        const Kind order = kind != draco::MESH_VERTEX_ATTRIBUTE                   ? Kind::corners
                           : traversal == draco::MESH_TRAVERSAL_PREDICTION_DEGREE ? Kind::verticesByDegree
                                                                                  : Kind::vertices;
        auto owned = std::make_unique<EdgebreakerOrder>(*this, order);
        EdgebreakerOrder* const edgebreaker = owned.get();
        return addGroup(id, std::move(owned), edgebreaker);
    }
};

/// What went wrong, if anything did.
std::optional<std::string> decodeInto(draco::Mesh& mesh, const DracoStream& stream, DracoGuard& guard) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(stream.bytes.data()), stream.bytes.size());
    std::unique_ptr<draco::MeshDecoder> decoder;
    if (stream.isEdgebreaker) {
        decoder = std::make_unique<GuardedEdgebreaker>(guard);
    } else {
        decoder = std::make_unique<GuardedSequential>(guard);
    }
    const draco::DecoderOptions options;
    try {
        const draco::Status status = decoder->Decode(options, &buffer, &mesh);
        return status.ok() ? std::nullopt : std::optional(status.error_msg_string());
    } catch (const std::exception& error) {
        return error.what();
    }
}

} // namespace

std::unique_ptr<draco::Mesh> decodeGuarded(const DracoStream& stream, const DracoBounds& bounds,
                                           const std::string& where) {
    DracoGuard guard(stream, bounds);
    auto mesh = std::make_unique<draco::Mesh>();
    const std::optional<std::string> fault = decodeInto(*mesh, stream, guard);
    if (guard.reason()) {
        refuse("{}: {} holds {}", where, kDraco, *guard.reason());
    }
    if (fault) {
        refuse("{}: what {} holds is damaged: {}", where, kDraco, oneLine(*fault));
    }
    return mesh;
}

} // namespace cdr::scene::gltf
