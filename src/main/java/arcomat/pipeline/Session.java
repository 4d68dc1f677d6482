package arcomat.pipeline;

import java.nio.file.Path;

/**
 * Everything that the tool does goes through here, for whoever asks: the command line, a build, a
 * test.
 *
 * @param names the paths of files, as the user writes them
 * @param progress told of what is being done
 */
public record Session(PathNames names, Progress progress) {
    /**
     * @param directory the folder that relative paths start from
     */
    public static Session in(Path directory, Progress progress) {
        return new Session(new PathNames(directory.toAbsolutePath().normalize()), progress);
    }

    /**
     * Does what is asked for.
     *
     * @throws WrongUse where it does not fit what is there
     */
    public <R> R run(Task<R> task) throws WrongUse {
        return task.run(this);
    }
}
