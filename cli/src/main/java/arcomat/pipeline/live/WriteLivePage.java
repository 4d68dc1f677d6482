package arcomat.pipeline.live;

import arcomat.check.law.Profile;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckResult;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.file.FileFindings;
import arcomat.pipeline.file.ReportPage;
import arcomat.pipeline.live.LivePage.Beginning;
import arcomat.pipeline.live.LivePage.Text;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;

/**
 * Writes the live page of models and worlds. Errors in them are no obstacle: to repair them is what
 * the page is for.
 *
 * @param out the folder for the page
 */
public record WriteLivePage(String out, List<String> paths)
        implements Task<CheckedAnswer<Integer>> {

    /**
     * How many files there are on the page; what cannot be read is told instead.
     *
     * @throws WrongUse where there is no page in the installation, or it cannot be written
     */
    @Override
    public CheckedAnswer<Integer> run(Session session) throws WrongUse {
        ReportPage target = new ReportPage(out, session.names());
        target.requireWritable();
        LivePage page = LivePage.installed();
        CarriedWorlds carried = CarriedWorlds.find(paths, session.names());
        if (carried.models().isEmpty()) {
            throw new WrongUse("%s need models; name their folder as well", paths);
        }
        CheckedModels checked =
                CheckedModels.check(carried.models(), Profile.REQUIREMENTS, session);
        CheckResult result = checked.result();
        if (result.findings().stream().anyMatch(FileFindings::isUnreadableInput)) {
            return CheckedAnswer.refused(result);
        }
        session.progress().step("writing " + out + "/" + ReportPage.NAME);
        LoadedModels loaded = checked.loaded();
        List<Text> files =
                new ArrayList<>(texts(loaded, file -> loaded.isNamedByUser(file.path())));
        carried.worlds().forEach(world -> files.add(Text.of(world)));
        Beginning models =
                new Beginning(files, texts(loaded, file -> !loaded.isNamedByUser(file.path())));
        target.write(page.with(models));
        return CheckedAnswer.of(result, models.files().size());
    }

    private static List<Text> texts(LoadedModels loaded, Predicate<SourceFile> wanted) {
        return loaded.sources().stream().filter(wanted).map(Text::of).toList();
    }
}
