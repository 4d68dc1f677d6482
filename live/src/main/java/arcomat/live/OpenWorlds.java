package arcomat.live;

import arcomat.live.json.JsonText;
import arcomat.live.robot.RobotPrograms;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.report.world.WorldJson;
import arcomat.report.world.WorldText;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Recording;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.WorldParser;

import java.util.List;

/** The worlds on the page, beside the models that their robots run. */
record OpenWorlds(List<SourceFile> texts) {
    private static final String ENDING = ".world";

    static final OpenWorlds NONE = new OpenWorlds(List.of());

    OpenWorlds {
        texts = List.copyOf(texts);
    }

    /** Those among some files. */
    static OpenWorlds among(List<SourceFile> files) {
        return new OpenWorlds(files.stream().filter(OpenWorlds::isWorld).toList());
    }

    static boolean isWorld(SourceFile file) {
        return file.path().endsWith(ENDING);
    }

    List<Diagnostic> findings() {
        return texts.stream().flatMap(each -> WorldParser.parse(each).findings().stream()).toList();
    }

    /**
     * A run, in the form in which pages of {@code arcomat world} have it.
     *
     * @throws WrongUse where it cannot run here, and why
     */
    String run(String path, long seed, LoweredModels models) throws WrongUse {
        SourceFile text =
                texts.stream()
                        .filter(each -> each.path().equals(path))
                        .findFirst()
                        .orElseThrow(() -> new WrongUse("there is no world '" + path + "'"));
        World world =
                WorldParser.parse(text)
                        .world()
                        .orElseThrow(
                                () ->
                                        new WrongUse(
                                                "there are errors in the world; repair them"
                                                        + " first"));
        Recording recording = RobotPrograms.of(world, models).run(Seeds.of(seed));
        return JsonText.object(
                json -> {
                    json.field("headline", WorldText.summary(recording));
                    json.field("good", recording.succeeded());
                    json.value("recording", WorldJson.fields(recording));
                });
    }
}
