#include <cdr/base/format_error.h>
#include <cli/command.h>
#include <cli/commands.h>
#include <cli/picture_folder.h>
#include <experiments/models/model_sheet.h>
#include <experiments/models/models.h>
#include <scenes/open_scene.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <options/help_texts.h>
#include <options/parsed_option.h>
#include <output/columns.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace cdr::cli {

namespace {

constexpr const char* kModelSheet = "models_sheet.png";
/// Each is a row of the sheet, and its four pictures stay in memory for that.
constexpr std::size_t kMaxModels = 256;
constexpr std::uint64_t kMaxPictureBytes = std::uint64_t{4} << 30u;

/// One of a model's pictures.
struct ModelPicture {
    const char* end; ///< of the file's name, after the model's
    image::ImageRgba8 experiments::ModelResult::*image;
};
constexpr std::array<ModelPicture, experiments::kModelPictures> kPicturesOfModel{
    {{"_plain.png", &experiments::ModelResult::plain},
     {".png", &experiments::ModelResult::picture},
     {"_reference.png", &experiments::ModelResult::reference},
     {"_flip.png", &experiments::ModelResult::difference}}};

struct ModelsArguments {
    std::vector<std::string> files;
    experiments::ModelsOptions options;
    depth::NamedTechnique technique = depth::namedTechnique("anchored");
    scene::ModelLight light = scene::ModelLight::sky;
    std::optional<double> seconds;
    std::optional<std::uint32_t> camera;
    std::filesystem::path folder;
};

output::Columns<experiments::ModelResult> modelColumns() {
    using Result = experiments::ModelResult;
    const output::CellFormat percent{.pattern = "{} %", .scale = 100.0};
    return {{.key = "model", .value = &Result::model, .heading = "model"},
            {.key = "light", .value = &Result::light, .heading = "light"},
            {.key = "triangles", .value = &Result::triangles, .heading = "triangles"},
            {.key = "textures", .value = &Result::textures, .heading = "textures"},
            {.key = "covered_fraction",
             .value = &Result::coveredFraction,
             .heading = "covered",
             .format = percent},
            {.key = "flip", .value = &Result::flip, .heading = "mean FLIP"},
            {.key = "covered_flip", .value = &Result::coveredFlip, .heading = "where covered"},
            {.key = "mean_steps", .value = &Result::meanSteps, .heading = "8-bit steps"}};
}

/// A file's name, after those of so many of the folders that it is in.
std::string nameWithFolders(const std::string& file, std::size_t folders) {
    std::filesystem::path path = std::filesystem::absolute(file).lexically_normal();
    std::string name = path.stem().string();
    for (; folders > 0 && path.has_relative_path(); --folders) {
        path = path.parent_path();
        name = fmt::format("{}_{}", path.filename().string(), name);
    }
    return name;
}

/// What each model's pictures are called: its file's name, after as many folders as tell it from the others.
/// base::InputError where two would still have one name.
std::vector<std::string> pictureNames(const std::vector<std::string>& files) {
    std::vector<std::string> names(files.size());
    std::vector<std::size_t> folders(files.size(), 0);
    constexpr std::size_t kMaxFolders = 8;
    for (std::size_t round = 0; round <= kMaxFolders; ++round) {
        std::map<std::string, std::vector<std::size_t>> byName;
        for (std::size_t i = 0; i < files.size(); ++i) {
            names[i] = nameWithFolders(files[i], folders[i]);
            byName[names[i]].push_back(i);
        }
        if (byName.size() == files.size()) {
            return names;
        }
        for (const auto& [name, alike] : byName) {
            for (const std::size_t i : alike) {
                folders[i] += alike.size() > 1 ? 1 : 0;
            }
        }
    }
    std::set<std::string> taken;
    const auto twice = std::find_if(names.begin(), names.end(),
                                    [&](const std::string& name) { return !taken.insert(name).second; });
    const std::string& file = files[static_cast<std::size_t>(twice - names.begin())];
    throw base::inputError("two models would both be written as {}_*.png", nameWithFolders(file, 0));
}

/// base::InputError for what is no model.
void requireModels(const std::vector<std::string>& files) {
    if (files.size() > kMaxModels) {
        throw base::inputError("{} models are too many: at most {} are allowed", files.size(), kMaxModels);
    }
    for (const std::string& file : files) {
        if (!scene::isGltfPath(file)) {
            throw base::InputError(file + ": models are .gltf and .glb files");
        }
    }
}

/// base::InputError where the pictures of all models take more memory than is allowed.
void requirePictureMemory(std::size_t models, const experiments::ModelsOptions& options) {
    const std::uint64_t bytes = models * experiments::kModelPictures * sizeof(image::Rgba8) *
                                std::uint64_t{options.drawing.width} * options.drawing.height;
    if (bytes > kMaxPictureBytes) {
        throw base::inputError("the pictures of {} models at {}x{} take {} MiB, {} are allowed: give "
                               "fewer models or a smaller --size",
                               models, options.drawing.width, options.drawing.height, bytes >> 20u,
                               kMaxPictureBytes >> 20u);
    }
}

/// A model as chosen. Of one without animations no moment is chosen.
scene::OpenedScene openModel(const std::string& file, const scene::GltfChoice& choice,
                             std::optional<double> seconds) {
    scene::GltfChoice chosen = choice;
    scene::OpenedScene opened = scenes::openScene(file, scenes::kDefaultSeed, chosen);
    if (seconds && !opened.animations.empty()) {
        chosen.seconds = seconds;
        opened = scenes::openScene(file, scenes::kDefaultSeed, chosen);
    }
    return opened;
}

/// The files that are written of models.
std::vector<std::string> modelFiles(const std::vector<std::string>& models) {
    std::vector<std::string> files{kModelSheet};
    for (const std::string& model : models) {
        for (const ModelPicture& picture : kPicturesOfModel) {
            files.push_back(model + picture.end);
        }
    }
    return files;
}

/// base::InputError where two of the files would be one: a model may be named as another one's picture, or as the sheet.
void requireApart(std::vector<std::string> files) {
    std::ranges::sort(files);
    if (const auto twice = std::ranges::adjacent_find(files); twice != files.end()) {
        throw base::inputError("two pictures would both be written as {}", *twice);
    }
}

void writePictures(const PictureFolder& folder, const std::vector<experiments::ModelResult>& results,
                   const std::string& device) {
    for (const experiments::ModelResult& result : results) {
        for (const ModelPicture& picture : kPicturesOfModel) {
            folder.write(result.model + picture.end, result.*picture.image);
        }
    }
    folder.write(kModelSheet, experiments::makeModelSheet(results, "cdr models, " + device));
}

void run(Command& command, ModelsArguments& arguments) {
    requireModels(arguments.files);
    const std::vector<std::string> names = pictureNames(arguments.files);
    requirePictureMemory(arguments.files.size(), arguments.options);
    arguments.options.closer = !arguments.camera.has_value();
    arguments.options.drawing.technique = arguments.technique.technique;
    const PictureFolder folder(arguments.folder, command.files(), PictureFolder::oneOf(modelFiles(names)));
    if (folder.isWanted()) {
        requireApart(modelFiles(names));
    }
    std::vector<experiments::ModelResult> results;
    for (const std::string& file : arguments.files) {
        command.reads(file);
    }
    const auto progress = command.progress();
    for (const std::string& file : arguments.files) {
        progress(results.size(), arguments.files.size(), file);
        scene::GltfChoice choice = command.modelChoice();
        choice.camera = arguments.camera;
        choice.light = arguments.light;
        const scene::OpenedScene model = openModel(file, choice, arguments.seconds);
        command.note(file, model.notes);
        choice.light = scene::ModelLight::lamps;
        const scene::OpenedScene plain = openModel(file, choice, arguments.seconds);
        results.push_back(experiments::compareModel(command.device(), model.setup, plain.setup,
                                                    arguments.light, arguments.options));
        results.back().model = names[results.size() - 1];
    }
    command.endProgress();
    if (folder.isWanted()) { // else the sheet is made for nothing
        writePictures(folder, results, command.device().info().name);
    }
    const auto columns = modelColumns();
    command.console().table(output::tableOf(columns, results));
    command.console().line(fmt::format(
        "\n{}; {}x{}, {}; a FLIP of 0 means no difference{}", command.opened().text(),
        arguments.options.drawing.width, arguments.options.drawing.height, arguments.technique.name,
        folder.isWanted() ? fmt::format("; pictures in {}, all on {}", folder.path().string(),
                                        (folder.path() / kModelSheet).string())
                          : ""));
    auto document = command.makeDocument({{"width", arguments.options.drawing.width},
                                          {"height", arguments.options.drawing.height},
                                          {"technique", arguments.technique.name},
                                          {"light", nameOf(arguments.light)}});
    document["results"] = output::jsonOf(columns, results);
    command.writeDocument(document);
}

void addOptions(CLI::App& command, ModelsArguments& arguments) {
    command.add_option("models", arguments.files, "glTF files, .gltf or .glb")->required();
    options::addFolder(command, "--out", arguments.folder, "Folder for the pictures and one sheet of all");
    options::addParsed(command, "--technique", arguments.technique, depth::namedTechnique,
                       "Technique: " + options::techniqueHelp())
        ->default_str(arguments.technique.name)
        ->check(options::namesOne("technique"));
    options::addNamed(command, "--light", arguments.light, scene::parseModelLight, options::kLightHelp);
    command.add_option("--time", arguments.seconds, "Time in the first animation of a model, in seconds");
    command.add_option("--camera", arguments.camera, options::kCameraHelp)
        ->default_str("one that the model fills");
    addSize(command, arguments.options.drawing.width, arguments.options.drawing.height);
    addThreads(command, arguments.options.drawing.threads);
}

} // namespace

void addModels(CLI::App& program, const GlobalOptions& global) {
    addCommand<ModelsArguments>(
        program, global, "models",
        "Compare pictures of glTF models with a float64 reference, by the image difference FLIP", addOptions,
        run);
}

} // namespace cdr::cli
