package arcomat.pipeline.check;

import arcomat.check.law.Profile;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;

import java.util.List;

/**
 * Checks files and folders.
 *
 * @param executable also asks for what a model needs in order to run
 */
public record CheckFiles(List<String> paths, boolean executable) implements Task<CheckResult> {
    @Override
    public CheckResult run(Session session) {
        return CheckedModels.check(paths, profile(executable), session).result();
    }

    /** What models have to fulfil. */
    public static Profile profile(boolean executable) {
        return executable ? Profile.EXECUTABLE : Profile.REQUIREMENTS;
    }
}
