package arcomat.pipeline.explored;

import arcomat.analysis.search.external.ExternalMemory;
import arcomat.pipeline.explored.BlockFile.Damaged;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.LongBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.zip.CRC32C;

/**
 * A memory of files in a folder. One of them, replaced as a whole, says what is committed: which
 * files, how long, and notes. Whatever else is there is of an interrupted search, and is removed.
 */
final class BlockFolder implements ExternalMemory, Closeable {
    private static final String STATE = "committed";
    private static final String FRESH = "committed.tmp";
    private static final String BLOCKS = ".blocks";
    private static final long MAGIC = 0x4172_636f_6d61_7431L;

    private final Path folder;
    private final Map<Long, BlockFile> open = new TreeMap<>();
    private final Map<Long, Long> committed = new TreeMap<>();
    private Optional<long[]> notes = Optional.empty();
    private long lastName;

    private BlockFolder(Path folder) {
        this.folder = folder;
    }

    static BlockFolder in(Path folder) throws IOException {
        Files.createDirectories(folder);
        BlockFolder memory = new BlockFolder(folder);
        memory.readState();
        memory.removeOthers();
        return memory;
    }

    private void readState() throws IOException {
        Path state = folder.resolve(STATE);
        if (!Files.exists(state)) {
            return;
        }
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(state));
        int length = bytes.capacity() - Long.BYTES;
        if (length < 3 * Long.BYTES
                || checksum(bytes.slice(0, length)) != bytes.getLong(length)
                || bytes.getLong(0) != MAGIC) {
            throw new Damaged("'" + STATE + "' is damaged");
        }
        LongBuffer words = bytes.slice(0, length).asLongBuffer().position(1);
        for (long files = words.get(); files > 0; files--) {
            long name = words.get();
            committed.put(name, words.get());
            lastName = Math.max(lastName, name);
        }
        long[] rest = new long[(int) words.get()];
        words.get(rest);
        notes = Optional.of(rest);
    }

    private static long checksum(ByteBuffer bytes) {
        CRC32C checksum = new CRC32C();
        checksum.update(bytes);
        return checksum.getValue();
    }

    private void removeOthers() throws IOException {
        List<Path> files;
        try (var all = Files.list(folder)) {
            files = all.filter(file -> isOther(file.getFileName().toString())).toList();
        }
        for (Path file : files) {
            Files.delete(file);
        }
    }

    private boolean isOther(String file) {
        boolean kept = committed.keySet().stream().anyMatch(name -> file.equals(name + BLOCKS));
        return file.equals(FRESH) || file.endsWith(BLOCKS) && !kept;
    }

    @Override
    public int blockWords() {
        return BlockFile.WORDS;
    }

    @Override
    public Volume create() {
        try {
            long name = ++lastName;
            BlockFile file = BlockFile.create(path(name), name);
            open.put(name, file);
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public Volume open(long name, long blocks) {
        try {
            if (!Long.valueOf(blocks).equals(committed.get(name))) {
                throw new Damaged("'" + name + BLOCKS + "' is of another time");
            }
            BlockFile file = BlockFile.open(path(name), name, blocks);
            open.put(name, file);
            return file;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Path path(long name) {
        return folder.resolve(name + BLOCKS);
    }

    @Override
    public void commit(long[] fresh, List<Volume> kept) {
        try {
            Map<Long, Long> lengths = new TreeMap<>();
            for (Volume each : kept) {
                Objects.requireNonNull(open.get(each.name())).force();
                lengths.put(each.name(), each.blocks());
            }
            writeState(fresh, lengths);
            committed.clear();
            committed.putAll(lengths);
            notes = Optional.of(fresh);
            for (long name : List.copyOf(open.keySet())) {
                if (!committed.containsKey(name)) {
                    Objects.requireNonNull(open.remove(name)).close();
                }
            }
            removeOthers();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void writeState(long[] fresh, Map<Long, Long> lengths) throws IOException {
        int words = 4 + 2 * lengths.size() + fresh.length;
        ByteBuffer bytes = ByteBuffer.allocate(words * Long.BYTES);
        bytes.putLong(MAGIC).putLong(lengths.size());
        lengths.forEach((name, blocks) -> bytes.putLong(name).putLong(blocks));
        bytes.putLong(fresh.length);
        bytes.asLongBuffer().put(fresh);
        int length = bytes.capacity() - Long.BYTES;
        bytes.putLong(length, checksum(bytes.slice(0, length)));
        bytes.clear();
        Path written = folder.resolve(FRESH);
        try (FileChannel channel =
                FileChannel.open(
                        written,
                        StandardOpenOption.CREATE,
                        StandardOpenOption.TRUNCATE_EXISTING,
                        StandardOpenOption.WRITE)) {
            while (bytes.hasRemaining()) {
                channel.write(bytes);
            }
            channel.force(true);
        }
        Files.move(
                written,
                folder.resolve(STATE),
                StandardCopyOption.ATOMIC_MOVE,
                StandardCopyOption.REPLACE_EXISTING);
        forceNames();
    }

    /** Only then the state is found under its name after the machine went down. */
    private void forceNames() {
        try (FileChannel names = FileChannel.open(folder, StandardOpenOption.READ)) {
            names.force(true);
        } catch (IOException notHere) {
            // Windows opens no folders, and keeps names by itself.
        }
    }

    @Override
    public Optional<long[]> notes() {
        return notes;
    }

    @Override
    public void close() throws IOException {
        List<BlockFile> files = new ArrayList<>(open.values());
        open.clear();
        for (BlockFile each : files) {
            each.close();
        }
        removeOthers();
    }
}
