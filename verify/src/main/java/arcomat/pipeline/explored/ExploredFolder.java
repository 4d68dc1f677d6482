package arcomat.pipeline.explored;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.explored.BlockFile.Damaged;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** A folder for what is explored to answer a question, or several, while it is used. */
public final class ExploredFolder implements Closeable {
    private static final String QUESTION = "question";
    private static final String LOCK = "lock";

    private final String written;
    private final Path folder;
    private final FileChannel lock;

    /** How many promises had a name so far. */
    private final Map<String, Integer> named = new HashMap<>();

    private ExploredFolder(String written, Path folder, FileChannel lock) {
        this.written = written;
        this.folder = folder;
        this.lock = lock;
    }

    /**
     * Begins, or goes on, with the question whether one component refines another.
     *
     * @param written the folder, as the user wrote it
     * @param version of the tool
     * @throws WrongUse where the folder is of something else, or cannot be used
     */
    public static ExploredFolder ofRefinement(
            String written,
            Promise left,
            Promise right,
            List<SourceFile> models,
            String version,
            PathNames names)
            throws WrongUse {
        return open(written, ExploredQuestion.ofRefinement(left, right, models, version), names);
    }

    /** As above, with all that models promise. */
    public static ExploredFolder ofPromises(
            String written, List<SourceFile> models, String version, PathNames names)
            throws WrongUse {
        return open(written, ExploredQuestion.ofPromises(models, version), names);
    }

    private static ExploredFolder open(String written, ExploredQuestion question, PathNames names)
            throws WrongUse {
        Path folder = names.resolve(written);
        try {
            if (Files.exists(folder) && !Files.isDirectory(folder)) {
                throw new WrongUse("'%s' is a file; --disk names a folder", written);
            }
            requireSame(question, folder, written);
            Files.createDirectories(folder);
            FileChannel lock = lock(folder, written);
            AtomicFile.write(folder.resolve(QUESTION), question.text());
            return new ExploredFolder(written, folder, lock);
        } catch (IOException e) {
            throw Failures.cannot("use", written, e);
        }
    }

    private static void requireSame(ExploredQuestion question, Path folder, String written)
            throws IOException, WrongUse {
        if (!Files.isDirectory(folder)) {
            return;
        }
        Path file = folder.resolve(QUESTION);
        if (!Files.isRegularFile(file)) {
            try (Stream<Path> files = Files.list(folder)) {
                if (files.anyMatch(each -> !each.endsWith(LOCK))) {
                    throw new WrongUse(
                            "'%s' is there and holds nothing that was explored; name another"
                                    + " folder",
                            written);
                }
            }
            return;
        }
        Optional<String> difference =
                ExploredQuestion.parse(Files.readString(file))
                        .map(before -> before.difference(question))
                        .orElse(Optional.of("something that cannot be read"));
        if (difference.isPresent()) {
            throw new WrongUse(
                    "'%s' is about %s; name another folder, or remove it to begin anew",
                    written, difference.get());
        }
    }

    private static FileChannel lock(Path folder, String written) throws IOException, WrongUse {
        FileChannel channel =
                FileChannel.open(
                        folder.resolve(LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        try {
            FileLock lock = channel.tryLock();
            if (lock != null) {
                return channel;
            }
        } catch (OverlappingFileLockException ours) {
            // In this very process.
        }
        channel.close();
        throw new WrongUse("'%s' is in use by another search; wait for it to end", written);
    }

    /** The place of the one question that the folder is about. */
    public ExploredSearches alone() {
        return in(folder);
    }

    /**
     * The place of one of the promises that the folder is about. Each has its own, also where names
     * are alike; with the same models they are asked in the same order.
     */
    public ExploredSearches of(String title) {
        PromiseName name = new PromiseName(title, named.merge(title, 1, Integer::sum));
        return in(folder.resolve(name.asFile()));
    }

    private ExploredSearches in(Path place) {
        return new ExploredSearches(written, place, Runtime.getRuntime().maxMemory());
    }

    /** What the user is told where the files failed. */
    public static WrongUse failure(String written, UncheckedIOException failed) {
        IOException reason = Objects.requireNonNull(failed.getCause());
        return new WrongUse(
                "cannot keep what is explored in '%s': %s; %s",
                written,
                Failures.reason(reason),
                reason instanceof Damaged
                        ? "remove the folder to begin anew"
                        : "what was kept before is still there: mend that, and the same command"
                                + " goes on from it");
    }

    @Override
    public void close() throws IOException {
        lock.close();
    }
}
