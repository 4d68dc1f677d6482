package arcomat.pipeline;

import arcomat.check.LawBook;

import java.nio.file.Path;

/**
 * Everything that the tool does goes through here, for whoever asks: the command line, a build, a
 * test.
 *
 * @param names the paths of files, as the user writes them
 * @param progress told of what is being done
 * @param laws that models are checked by
 */
public record Session(PathNames names, Progress progress, LawBook laws) {
    /** Without guests. */
    public Session(PathNames names, Progress progress) {
        this(names, progress, LawBook.OWN);
    }

    /**
     * @param directory the folder that relative paths start from
     */
    public static Session in(Path directory, Progress progress) {
        return new Session(new PathNames(directory.toAbsolutePath().normalize()), progress);
    }

    /** The same, told of to somebody else. */
    public Session with(Progress other) {
        return new Session(names, other, laws);
    }

    /** The same, with these laws. */
    public Session with(LawBook other) {
        return new Session(names, progress, other);
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
