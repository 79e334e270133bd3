#include "program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <ostream>

namespace cdr::cli_test {

namespace {

struct BadInput {
    const char* arguments;
    const char* says; ///< a part of the message

    friend std::ostream& operator<<(std::ostream& out, const BadInput& bad) { return out << bad.arguments; }
};

/// Each ends with one line, exit status 2, and nothing written.
class BadInputTest : public FolderTest, public testing::WithParamInterface<BadInput> {};

TEST_P(BadInputTest, IsRefusedInOneLine) {
    expectRefusal(GetParam().arguments, GetParam().says);
    EXPECT_TRUE(folderIsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Arguments, BadInputTest,
    testing::Values(
        BadInput{"--quiet", "a command is missing"}, BadInput{"rendr", "did you mean 'render'"},
        BadInput{"render", "scene"},
        BadInput{"render afc --techniqe log",
                 "cdr render has no option --techniqe; did you mean --technique?"},
        BadInput{"render afc --techniqe=log",
                 "cdr render has no option --techniqe; did you mean --technique?"},
        BadInput{"render afc --jsn a.json", "has no option --jsn; did you mean --json?"},
        BadInput{"orbit --quite", "has no option --quite; did you mean --quiet?"},
        BadInput{"render afc --xyzzyxyzzy 1",
                 "cdr render has no option --xyzzyxyzzy; cdr render --help lists"},
        BadInput{"render afc mixed", "cdr render takes no further word 'mixed'"},
        BadInput{"render afc --certify a.json --fog 10", "a frame with effects cannot be certified"},
        BadInput{"render afc --certify a.json --detail object",
                 "a frame with levels of detail cannot be certified"},
        BadInput{"render afc --certify a.json --json a.json", "a.json"},
        BadInput{"render afc --certify a.png", "--certify: a.png does not end in .json"},
        BadInput{"render afc --near 5 --far 5 -o a.png", "far must be finite and beyond near"},
        BadInput{"render afc --near 5 --far 1 -o a.png", "far must be finite and beyond near"},
        BadInput{"render afc --near 0 -o a.png", "near must be finite and above 0"},
        BadInput{"render afc --near=-1 -o a.png", "near must be finite and above 0"},
        BadInput{"render afc --near nan -o a.png", "near"}, BadInput{"render afc --far inf -o a.png", "far"},
        BadInput{"render afc --fov nan -o a.png", "field of view"},
        BadInput{"render afc --fov 180 -o a.png", "field of view"},
        BadInput{"render afc --fov 1e-36 -o a.png", "field of view must be at least 1e-28 degrees"},
        BadInput{"render afc --eye 1,2 -o a.png", "three numbers"},
        BadInput{"render afc --eye 1,2,inf -o a.png", "finite number"},
        BadInput{"render afc --eye 1,2,3 --target 1,2,3 -o a.png", "same point"},
        BadInput{"render afc --direction 0,0,0 -o a.png", "view direction must not be zero"},
        BadInput{"render afc --direction 0,0 -o a.png", "three numbers"},
        BadInput{"render afc --direction 0,0,-1 --target 0,0,0 -o a.png", "--direction"},
        BadInput{"render afc --direction 0,0,-1 --up 0,0,3 -o a.png", "up lies along the view"},
        BadInput{"render afc --up 0,0,0 -o a.png", "up must not be zero"},
        BadInput{"render afc --path p.json --eye 1,2,3 -o a.png", "--path"},
        BadInput{"render afc --path p.json --frame 3 -o a.png", "--path"},
        BadInput{"render afc --path p.json -o a.png", "p.json"},
        BadInput{"render afc --size 0x720 -o a.png", "size must be"},
        BadInput{"render afc --size 40000x40000 -o a.png", "each side must be 1 to"},
        BadInput{"render afc --size 1000000000x1 -o a.png", "each side must be 1 to"},
        BadInput{"render afc --size 12 -o a.png", "size must be"},
        BadInput{"render afc --size=-1x5 -o a.png", "size must be"},
        BadInput{"render afc --technique reversd -o a.png", "did you mean 'reversed'"},
        BadInput{"render afc --depth lgo -o a.png", "did you mean 'log'"},
        BadInput{"render afc --split ratio:1 -o a.png", "split ratio must be above 1"},
        BadInput{"render afc --technique log --depth log -o a.png", "either --technique"},
        BadInput{"render afc --format d8 -o a.png", "unknown depth format"},
        BadInput{"render afc --antialias edge -o a.png", "did you mean 'edges'"},
        BadInput{"render afc --occlusion x -o a.png", "--occlusion"},
        BadInput{"render afc --occlusion 1:layer -o a.png", "RADIUS:layers"},
        BadInput{"render afc --occlusion=-1 -o a.png", "not negative"},
        BadInput{"render afc --occlusion 1:layers -o a.png", "needs layered targets"},
        BadInput{"render afc --fog 10,1 -o a.png", "VISIBILITY,r,g,b"},
        BadInput{"render afc --fog 10,1,2,0 -o a.png", "colour of fog"},
        BadInput{"render afc --fog 10, -o a.png", "VISIBILITY,r,g,b"},
        BadInput{"render afc --occlusion 5: -o a.png", "RADIUS:layers"},
        BadInput{"render afc --targets layers --focus 10:1: -o a.png", "DISTANCE:APERTURE"},
        BadInput{"render afc --focus 10 -o a.png", "DISTANCE:APERTURE"},
        BadInput{"render afc --focus 10:1:blnd -o a.png", "DISTANCE:APERTURE"},
        BadInput{"render afc --focus 10:x -o a.png", "--focus"},
        BadInput{"render afc --focus 10:-1 --targets layers -o a.png", "aperture"},
        BadInput{"render afc --focus 10:1 -o a.png", "needs targets layers"},
        BadInput{"focus --aperture 0 --json f.json", "above 0"},
        BadInput{"render afc --targets singel -o a.png", "did you mean 'single'"},
        BadInput{"render sheets --translucency srted -o a.png", "did you mean 'sorted'"},
        BadInput{"render alley --shadows anchred -o a.png", "did you mean 'anchored'"},
        BadInput{"render afc --stereo toedin --eye-distance 1 -o a.png",
                 "did you mean 'toed-in'? (known: none, parallel, toed-in, off-axis)"},
        BadInput{"render afc --stereo parallel -o a.png", "--stereo needs an --eye-distance"},
        BadInput{"render afc --stereo toed-in --eye-distance 1 -o a.png", "--converge"},
        BadInput{"render afc --stereo off-axis --eye-distance 1 -o a.png",
                 "--stereo off-axis needs a distance"},
        BadInput{"scaling --ranks --csv a.csv", "--csv"},
        BadInput{"timing --memory --modes log", "cannot be combined with --memory"},
        BadInput{"timing --stages --modes naive --frames 1 --size 16x16",
                 "naive cannot be measured with --stages"},
        BadInput{"effects --fog 0 --size 16x16", "must be above 0"},
        BadInput{"scaling --project 4 --plot a.svg", "--plot"}, BadInput{"scaling --heights 36", "--ranks"},
        BadInput{"scaling --frames 36", "--project"}, BadInput{"scaling --project 0", "--project"},
        BadInput{"scaling --project 1000001", "--project"},
        BadInput{"scaling --project 4 --frames 0", "--frames"},
        BadInput{"render afc --lens-shift 1 -o a.png", "--lens-shift must be two numbers x,y, not '1'"},
        BadInput{"render afc --lens-shift 1,x -o a.png", "--lens-shift"},
        BadInput{"render afc --lens-shift nan,0 -o a.png", "--lens-shift"},
        BadInput{"render alley --lens-shift 1e9,0 -o a.png", "the shift of this lens must lie between"},
        BadInput{"render afc --views six --size 8x8 --lens-shift 1,0 -o a.png",
                 "leave out --fov and --lens-shift"},
        BadInput{"render afc --eye-distance 1 -o a.png", "give --stereo too"},
        BadInput{"render afc --converge 1 -o a.png", "give --stereo too"},
        BadInput{"render afc --stereo-picture anaglyph -o a.png", "give --stereo too"},
        BadInput{"render afc --stereo parallel --eye-distance 0 -o a.png",
                 "eye distance must be finite and above 0, not 0"},
        BadInput{"render afc --stereo parallel --eye-distance 1 --converge 0 -o a.png",
                 "convergence distance must be finite and above 0, not 0"},
        BadInput{"render afc --stereo parallel --eye-distance 1 --converge 1e-3 -o a.png",
                 "would not overlap"},
        BadInput{"render afc --stereo parallel --eye-distance 1e-9 --eye 1e9,0,0 -o a.png",
                 "is lost in the rounding of the camera's position"},
        BadInput{"render afc --stereo parallel --eye-distance 1 --stereo-picture anaglif -o a.png",
                 "did you mean 'anaglyph'"},
        BadInput{"render afc --stereo parallel --eye-distance 1 --stereo-picture anaglyph --aov id -o a.png",
                 "anaglyph shows colors"},
        BadInput{"render afc --stereo parallel --eye-distance 1 --certify a.json",
                 "--certify works with one view"},
        BadInput{"render afc --stereo parallel --eye-distance 1 --ranks cascades -o a.png",
                 "--ranks cascades works with one view"},
        BadInput{"render afc --views sx -o a.png", "did you mean 'six'"},
        BadInput{"render afc --views six -o a.png", "--views six has square pictures"},
        BadInput{"render afc --views six --size 8x8 --fov 50 -o a.png", "--fov"},
        BadInput{"render afc --views six --size 8x8 --stereo parallel --eye-distance 1 -o a.png",
                 "either --stereo or --views six"},
        BadInput{"render alley --shadow-texels 63 -o a.png", "--shadow-texels"},
        BadInput{"shadows alley --methods plan --json t.json", "did you mean 'plain'"},
        BadInput{"shadows alley --methods none --json t.json", "nothing to compare"},
        BadInput{"rivals afk --json t.json", "did you mean 'afc'"},
        BadInput{"rivals mixed --rivals object-anchor --json t.json", "did you mean 'object-anchors'"},
        BadInput{"probe --rivals atomic --json t.json", "unknown rival 'atomic'"},
        BadInput{"flicker --rivals two-flat --json t.json", "did you mean 'two-float'"},
        BadInput{"orbit --rivals atomic-log/prepas --json t.json", "unknown rival"},
        BadInput{"timing --rivals object-anchor --json t.json", "did you mean 'object-anchors'"},
        BadInput{"rivals mixed --techniques reversed --json t.json", "must be among the techniques"},
        BadInput{"rivals coplanar --json t.json", "neither layer offsets nor masked materials"},
        BadInput{"models cubes --json t.json", "models are .gltf and .glb files"},
        BadInput{"render afc -o t.json --certify ''", "--certify: names no file"},
        BadInput{"render afc --state '' -o t.json", "--state: names no file"},
        BadInput{"flicker --tga '' --json t.json", "--tga: names no folder"},
        BadInput{"shadows alley --out t.json --json t.json", "t.json: both --out and --json would write it"},
        BadInput{"flicker --tga t.json --json ./t.json", "./t.json: both --tga and --json would write it"},
        BadInput{"flicker --json t.json --videos t.json", "t.json: both --videos and --json would write it"},
        BadInput{"models a/x.glb a/x.gltf --json t.json", "two models would both be written as x_*.png"},
        BadInput{"models a.glb b.glb c.glb d.glb e.glb --size 8192x8192 --json t.json",
                 "the pictures of 5 models at 8192x8192 take 5120 MiB, 4096 are allowed"},
        BadInput{"models none.glb --json t.json", "none.glb"}, BadInput{"models", "models is required"},
        BadInput{"models x.glb --light skies --json t.json", "known: lamps, sky, file"},
        BadInput{"render sheets --translucency-memory 0 -o a.png", "--translucency-memory"},
        BadInput{"render sheets --texture-memory 0 -o a.png", "--texture-memory"},
        BadInput{"render sheets --points 0 -o a.png", "--points"},
        BadInput{"--points nan inspect sheets", "--points"},
        BadInput{"render coplanar --layer poster -o a.png", "MATERIAL=LAYER"},
        BadInput{"render coplanar --layer poster=nan -o a.png", "a layer must be a finite number"},
        BadInput{"render coplanar --layer poster=1e39 -o a.png", "a layer must be a finite float"},
        BadInput{"render coplanar --layer poster=1e-320 -o a.png", "a layer must be 0 or at least"},
        BadInput{"render coplanar --layer pster=1 -o a.png", "did you mean 'poster'"},
        BadInput{"render coplanar --layer '#15=1' -o a.png", "counted from #0"},
        BadInput{"--texture-memory 1e3x inspect sheets", "--texture-memory"},
        BadInput{"translucency afc --json t.json", "no translucent surfaces"},
        BadInput{"translucency --cascades 2,65 --json t.json", "64"},
        BadInput{"render afc --targets pool:x -o a.png", "pool:N takes a whole number of layers"},
        BadInput{"render afc --targets pool:1 -o a.png", "a pool has 2 to 16 layers"},
        BadInput{"render afc --targets layers:2 -o a.png", "only pool:N does"},
        BadInput{"render afc --submission gpu -o a.png", "unknown submission 'gpu'"},
        BadInput{"render afc --batching instance -o a.png", "did you mean 'instanced'"},
        BadInput{"timing --in-flight 9", "in-flight"},
        BadInput{"timing --scene trafic", "did you mean 'traffic'"},
        BadInput{"timing --scene traffic --modes naive", "a scene that does not move"},
        BadInput{"scaling --submissions primary", "did you mean 'primaries'"},
        BadInput{"render afc --aov linear --surface lit", "no linear light is kept"},
        BadInput{"render afc --aov linear --certify c.json", "leave out --aov linear"},
        BadInput{"render afc --aov colour -o a.png", "did you mean 'color'"},
        BadInput{"render afc --threads 0 -o a.png", "--threads"},
        BadInput{"render afc --threads 100000 -o a.png", "--threads"},
        BadInput{"render afc --frames 0 -o a.png", "frames"},
        BadInput{"render afc --frames 2 -o a.png", "several frames need a number"},
        BadInput{"render afc -o a%s.png", "frame number"},
        BadInput{"render afc -o a.bmp", "unknown picture format"},
        BadInput{"render afc -o no/such/folder/a.png", "cannot be written"},
        BadInput{"render afc -o a.png --json no/such/folder/a.json", "cannot be written"},
        BadInput{"render acf -o a.png", "did you mean 'afc'"},
        BadInput{"render missing.glb -o a.png", "missing.glb"},
        BadInput{"render . -o a.png", "unknown scene"},
        BadInput{"--device nothing-like-this render afc -o a.png", "no Vulkan device matches"},
        BadInput{"--device nothing-like-this precision",
                 "no Vulkan device matches 'nothing-like-this': there "},
        BadInput{"precision --near 1 --far 1", "0 < near < far"}, BadInput{"pictures --frames 0", "frames"},
        BadInput{"pictures --techniques anchord", "did you mean 'anchored'"},
        BadInput{"render afc --depth anchored --split fitted:0px -o a.png", "must be above 0"},
        BadInput{"render afc --depth anchored --split fitted:1px,max=65 -o a.png", "from 1 to 64"},
        BadInput{"probe --distances 0.01", "from 0.1 to 1e16"},
        BadInput{"probe --distances 100,1e30", "from 0.1 to 1e16"},
        BadInput{"probe --distances nan", "distance"}, BadInput{"advise", "separation"},
        BadInput{"advise --separation 0", "above 0"},
        BadInput{"advise --separation 1 --at 1e9", "must lie from near"},
        BadInput{"advise --separation 1 --near 5 --far 5", "far must be finite and beyond near"},
        BadInput{"advise --separation 1 --fov 180", "field of view"},
        BadInput{"advise --separation 3 --near 1e20 --far 1e160",
                 "near and far must lie from 1e-30 to 1e+30, where float32"},
        BadInput{"render cubes --near 1e-300 --split minimax:3 -o a.png", "near and far must lie from"},
        BadInput{"render cubes --near 1e-38 -o a.png", "near and far must lie from"},
        BadInput{"render cubes --near 1e-31 --far 1 -o a.png", "near and far must lie from"},
        BadInput{"render cubes --far 1e39 -o a.png", "near and far must lie from"},
        BadInput{"render cubes --near 1e-20 --far 1e20 --depth log-fragment --split none -o a.png",
                 "far must be at most 1e+36 times near"},
        BadInput{"advise --separation 1 --span 0", "above 0"},
        BadInput{"advise --separation 1 --format d8", "unknown depth format"},
        BadInput{"probe --formats d25", "unknown depth format"},
        BadInput{"probe --techniques stndard", "did you mean 'standard'"},
        BadInput{"render afc --trace no/such/folder/t.json", "cannot be written"},
        BadInput{"render afc --threads 100000 --trace t.json", "--threads"},
        BadInput{"timing --frames 0", "frames"}, BadInput{"timing --size 0x5", "size must be"},
        BadInput{"timing --threads 0", "threads"}, BadInput{"timing --modes cdr-22", "did you mean 'cdr-2'"},
        BadInput{"timing --plot p.pdf", "unknown plot format"},
        BadInput{"timing --frames 1 --size 16x16 --modes log --against nosuch", "nosuch is not installed"},
        BadInput{"timing --against true --stages", "--stages"},
        BadInput{"timing --against true --rounds 0", "--rounds"}, BadInput{"timing --rounds 3", "--against"},
        BadInput{"timing --memory --stages", "--stages"},
        BadInput{"timing --stages --csv t.csv", "--csv and --trace cannot be combined with"},
        BadInput{"timing --memory --plot t.png", "--plot cannot be combined with"},
        BadInput{"timing --stages --in-flight 2", "--in-flight cannot be combined with"},
        BadInput{"timing --csv no/such/folder/t.csv", "cannot be written"},
        BadInput{"timing --trace no/such/folder/t.json", "cannot be written"},
        BadInput{"scaling --draws 0", "draws must be 1 to"}, BadInput{"scaling --draws 1000,x", "draws"},
        BadInput{"scaling --draws 99999999", "draws must be 1 to"},
        BadInput{"scaling --threads 1,0", "threads must be 1 to"},
        BadInput{"scaling --threads 257", "threads must be 1 to"},
        BadInput{"scaling --cascades 65", "cascades must be 1 to"},
        BadInput{"scaling --targets singel", "did you mean 'single'"},
        BadInput{"scaling --repeats 0", "repeats must be 1 to"},
        BadInput{"scaling --plot no/such/folder/p.png", "cannot be written"},
        BadInput{"precision --curve no/such/folder/c.csv", "cannot be written"},
        BadInput{"pictures --scenes cubes,nosuch", "unknown scene 'nosuch'"},
        BadInput{"orbit --threads 0", "--threads"},
        BadInput{"orbit --techniques anchored,anchored", "anchored is given twice"},
        BadInput{"flicker --techniques log,log", "log is given twice"},
        BadInput{"coplanar --techniques log,log", "log is given twice"},
        BadInput{"probe --techniques log,log", "log is given twice"},
        BadInput{"rivals cubes --techniques log,log", "log is given twice"},
        BadInput{"probe --rivals atomic-log,atomic-log", "atomic-log is given twice"},
        BadInput{"timing --memory --threads 3", "--threads cannot be combined with --memory"},
        BadInput{"shadows --techniques log,cdr,log --out o", "log is given twice"},
        BadInput{"shadows --methods plain,plain", "plain is given twice"},
        BadInput{"translucency --cascades 2,1,2", "--cascades 2 is given twice"},
        BadInput{"timing --modes cdr-2,log,cdr-2", "mode cdr-2 is given twice"},
        BadInput{"devices --device nothing-like-this", "no Vulkan device matches 'nothing-like-this'"},
        BadInput{"render cubes --frame 4294967295 --frames 2 -o a%d.png", "at most 4294967295"},
        BadInput{"render cubes --seed=-1 -o a.png", "from 0 to 18446744073709551615, not -1"},
        BadInput{"render cubes --seed -1 -o a.png", "from 0 to 18446744073709551615, not -1"},
        BadInput{"timing --seed 18446744073709551616", "not 18446744073709551616"},
        BadInput{"render cubes --seed 5x -o a.png", "--seed"}));

/// Options that would say nothing.
INSTANTIATE_TEST_SUITE_P(
    Unused, BadInputTest,
    testing::Values(BadInput{"advise --separation 1 --size 64x36", "--size requires --measured"},
                    BadInput{"advise --separation 1 --frames 2", "--frames requires --measured"},
                    BadInput{"advise --separation 1 --seed 2", "--seed requires --measured"},
                    BadInput{"advise --separation 1 --threads 2", "--threads requires --measured"},
                    BadInput{"render alley --shadow-texels 512 -o a.png",
                             "--shadow-texels requires --shadows"},
                    BadInput{"render sheets --translucency-memory 8 -o a.png",
                             "--translucency-memory requires --translucency"},
                    BadInput{"render cubes --deform cpu -o a.png", "--deform is for glTF files"}));

/// A scene behind --json, which takes it for its file.
INSTANTIATE_TEST_SUITE_P(Scenes, BadInputTest,
                         testing::Values(BadInput{"models --json a.gltf b.gltf", "write --json=FILE"},
                                         BadInput{"rivals --json cubes", "not the scene cubes"}));

/// An output that would take the place of another.
INSTANTIATE_TEST_SUITE_P(
    Outputs, BadInputTest,
    testing::Values(BadInput{"precision --json a --curve a", "both --json and --curve"},
                    BadInput{"timing --csv a --trace ./a", "both --csv and --trace"},
                    BadInput{"render afc -o a.png --json ./a.png", "both --json and -o"},
                    BadInput{"pictures --out . --json cubes_log.png", "both --out and --json"},
                    BadInput{"effects --out . --json plain.png", "both --out and --json"},
                    BadInput{"pictures --techniques log,cdr,log", "both be written as *_log.png"}));

/// A glTF that does not hold what it promises.
struct BadFile {
    const char* name;
    const char* content;

    friend std::ostream& operator<<(std::ostream& out, const BadFile& bad) { return out << bad.name; }
};
class BadFileTest : public FolderTest, public testing::WithParamInterface<BadFile> {};

TEST_P(BadFileTest, IsRefusedInOneLine) {
    const std::filesystem::path file = folder().string() + "_" + GetParam().name;
    std::ofstream(file) << GetParam().content;
    expectRefusal("render '" + file.string() + "' -o a.png", GetParam().name);
    EXPECT_TRUE(folderIsEmpty());
    std::filesystem::remove(file);
}

constexpr const char* kTriangle =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]},
{"bufferView":1,"componentType":5125,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":12}],
"buffers":[{"byteLength":48,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAABAAAACQAA"}]})";
constexpr const char* kEscape =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"../../../../../../etc/passwd"}]})";

INSTANTIATE_TEST_SUITE_P(Files, BadFileTest,
                         testing::Values(BadFile{"empty.gltf", ""},
                                         BadFile{"cut.gltf", "{\"asset\":{\"version\""},
                                         BadFile{"cut.glb", "glTF\x02"}, BadFile{"index.gltf", kTriangle},
                                         BadFile{"escape.gltf", kEscape}),
                         [](const auto& row) {
                             std::string name = row.param.name;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST(BadInput, AnUnwritableJsonOfPicturesIsRefusedBeforeRendering) {
    const TemporaryFolder folder;
    expectRefusal("pictures --out p --json no/such/folder/a.json", folder.path(), "cannot be written");
}

} // namespace

} // namespace cdr::cli_test
