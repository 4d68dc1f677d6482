package arcomat.pipeline;

import arcomat.check.LawBook;
import arcomat.guest.host.Guests;

import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * Everything that the tool does goes through here, for whoever asks: the command line, a build, a
 * test.
 *
 * @param names the paths of files, as the user writes them
 * @param progress told of what is being done
 * @param guests whose laws and languages are there besides the tool's
 * @param libraries model roots, as the user wrote them, that models may refer to and that somebody
 *     else is responsible for: nothing is asked about their models, nothing is made of them that
 *     their own project makes
 */
public record Session(PathNames names, Progress progress, Guests guests, List<String> libraries) {
    public Session {
        libraries = List.copyOf(libraries);
    }

    /** Without guests, for models that stand alone. */
    public Session(PathNames names, Progress progress) {
        this(names, progress, Guests.NONE, List.of());
    }

    /**
     * @param directory the folder that relative paths start from
     */
    public static Session in(Path directory, Progress progress) {
        return new Session(new PathNames(directory.toAbsolutePath().normalize()), progress);
    }

    /** The same, told of to somebody else. */
    public Session with(Progress other) {
        return new Session(names, other, guests, libraries);
    }

    /** The same, with these guests, and with the model roots that they have brought. */
    public Session with(Guests others) {
        Set<String> roots = new LinkedHashSet<>(libraries);
        roots.addAll(others.libraries());
        return new Session(names, progress, others, List.copyOf(roots));
    }

    /** The same, where models may refer to those of other projects. */
    public Session with(List<String> modelRoots) {
        return new Session(names, progress, guests, modelRoots);
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
