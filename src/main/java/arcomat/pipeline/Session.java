package arcomat.pipeline;

import arcomat.check.LawBook;
import arcomat.guest.host.Guests;

import java.nio.file.Path;

/**
 * Everything that the tool does goes through here, for whoever asks: the command line, a build, a
 * test.
 *
 * @param names the paths of files, as the user writes them
 * @param progress told of what is being done
 * @param guests whose laws and languages are there besides the tool's
 */
public record Session(PathNames names, Progress progress, Guests guests) {
    /** Without guests. */
    public Session(PathNames names, Progress progress) {
        this(names, progress, Guests.NONE);
    }

    /**
     * @param directory the folder that relative paths start from
     */
    public static Session in(Path directory, Progress progress) {
        return new Session(new PathNames(directory.toAbsolutePath().normalize()), progress);
    }

    /** The same, told of to somebody else. */
    public Session with(Progress other) {
        return new Session(names, other, guests);
    }

    /** The same, with these guests. */
    public Session with(Guests others) {
        return new Session(names, progress, others);
    }

    /** Whether there is somebody besides the tool. */
    public boolean hasGuests() {
        return !guests.laws().guests().isEmpty();
    }

    /** Those that models are checked by. */
    public LawBook laws() {
        return guests.laws();
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
