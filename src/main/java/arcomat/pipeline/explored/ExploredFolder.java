package arcomat.pipeline.explored;

import arcomat.analysis.refinement.Promise;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.external.ExternalPairs;
import arcomat.analysis.search.packed.PackedLayout;
import arcomat.analysis.search.packed.PackedNetwork;
import arcomat.analysis.search.packed.PairStore;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.explored.BlockFile.Damaged;
import arcomat.pipeline.file.AtomicFile;
import arcomat.pipeline.file.Failures;
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
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** A folder for what is explored to answer one question, while it is used. */
public final class ExploredFolder implements Closeable {
    private static final String QUESTION = "question";
    private static final String LOCK = "lock";

    /** Bytes of heap for each word of a pair: in tables, and while they are sorted. */
    private static final long BYTES = 128;

    /** Words beside the key of a pair. */
    private static final int BESIDE = 3;

    private static final long MOST_PAIRS = 50_000_000;

    private final Path folder;
    private final FileChannel lock;
    private final List<BlockFolder> open = new ArrayList<>();
    private final Map<Promise, Integer> asked = new HashMap<>();

    private ExploredFolder(Path folder, FileChannel lock) {
        this.folder = folder;
        this.lock = lock;
    }

    /**
     * Begins, or goes on.
     *
     * @param written the folder, as the user wrote it
     * @param version of the tool
     * @throws WrongUse where the folder is of something else, or cannot be used
     */
    public static ExploredFolder open(
            String written,
            Promise left,
            Promise right,
            List<SourceFile> models,
            String version,
            PathNames names)
            throws WrongUse {
        ExploredQuestion question = ExploredQuestion.of(left, right, models, version);
        Path folder = names.resolve(written);
        try {
            if (Files.exists(folder) && !Files.isDirectory(folder)) {
                throw new WrongUse("'%s' is a file; --disk names a folder", written);
            }
            requireSame(question, folder, written);
            Files.createDirectories(folder);
            FileChannel lock = lock(folder, written);
            AtomicFile.write(folder.resolve(QUESTION), question.text());
            return new ExploredFolder(folder, lock);
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

    /**
     * Places for the pairs of the search whether a promise is kept.
     *
     * @param budget asked on the way
     */
    public PairStore.Maker stores(Promise right, Budget budget) {
        int number = asked.computeIfAbsent(right, promise -> asked.size());
        int[] attempts = {0};
        return (network, layout) ->
                store(network, layout, number + "-" + attempts[0]++, budget::insist);
    }

    private PairStore store(
            PackedNetwork network, PackedLayout layout, String name, Runnable between) {
        try {
            BlockFolder memory = BlockFolder.in(folder.resolve(name));
            open.add(memory);
            long capacity = Runtime.getRuntime().maxMemory() / (BYTES * (layout.words() + BESIDE));
            return new ExternalPairs(
                    network, layout, memory, (int) Math.min(capacity, MOST_PAIRS), between);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Whether there is anything in it that can be gone on with. */
    public boolean isUsed() {
        return open.stream().anyMatch(each -> each.notes().isPresent());
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
        for (BlockFolder each : open) {
            each.close();
        }
        lock.close();
    }
}
