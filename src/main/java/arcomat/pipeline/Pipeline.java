package arcomat.pipeline;

import arcomat.check.Profile;

import java.nio.file.Path;
import java.util.List;

/** Everything that the tool does, for whoever asks: the command line, a build, a test. */
public final class Pipeline {
    private final PathNames names;
    private final Progress progress;

    /**
     * @param directory the folder that relative paths start from
     */
    public Pipeline(Path directory, Progress progress) {
        this.names = new PathNames(directory.toAbsolutePath().normalize());
        this.progress = progress;
    }

    /**
     * Checks files and folders.
     *
     * @param executable also asks for what a model needs in order to run
     */
    public CheckResult check(List<String> paths, boolean executable) {
        Profile profile = executable ? Profile.EXECUTABLE : Profile.REQUIREMENTS;
        return CheckedModels.check(paths, profile, names, progress).result();
    }

    /**
     * Brings files into canonical form.
     *
     * @param write false only lists what would change
     */
    public FormatResult format(List<String> paths, boolean write) {
        return FormatStep.run(paths, write, names, progress);
    }
}
