package arcomat.pipeline.explored;

import arcomat.analysis.search.external.ExternalMemory.Volume;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.zip.CRC32C;

/** A file of blocks, each with a checksum of its words and its place. */
final class BlockFile implements Volume, Closeable {
    /** Words of a block. */
    static final int WORDS = 1024;

    private static final int BYTES = (WORDS + 1) * Long.BYTES;

    /** Blocks that are written at once. */
    private static final int AT_ONCE = 32;

    private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

    private final Path file;
    private final long name;
    private final FileChannel channel;
    private ByteBuffer unwritten = NOTHING;
    private final ByteBuffer read = ByteBuffer.allocateDirect(BYTES);

    /** Those that are in the file; the others are not written yet. */
    private long written;

    private boolean forced;

    private BlockFile(Path file, long name, FileChannel channel, long written) {
        this.file = file;
        this.name = name;
        this.channel = channel;
        this.written = written;
    }

    static BlockFile create(Path file, long name) throws IOException {
        FileChannel channel =
                FileChannel.open(
                        file,
                        StandardOpenOption.CREATE_NEW,
                        StandardOpenOption.READ,
                        StandardOpenOption.WRITE);
        return new BlockFile(file, name, channel, 0);
    }

    /** As far as it was kept; what was written behind that is cut off. */
    static BlockFile open(Path file, long name, long blocks) throws IOException {
        FileChannel channel =
                FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE);
        if (channel.size() < blocks * BYTES) {
            channel.close();
            throw new Damaged("'" + file.getFileName() + "' is too short");
        }
        channel.truncate(blocks * BYTES);
        return new BlockFile(file, name, channel, blocks);
    }

    /** What is in a file is not what was written. */
    static final class Damaged extends IOException {
        private static final long serialVersionUID = 1L;

        Damaged(String message) {
            super(message);
        }
    }

    @Override
    public long name() {
        return name;
    }

    @Override
    public long blocks() {
        return written + unwritten.position() / BYTES;
    }

    @Override
    public void append(long[] block) {
        if (unwritten.capacity() == 0) {
            unwritten = ByteBuffer.allocate(AT_ONCE * BYTES);
        }
        int start = unwritten.position();
        unwritten.asLongBuffer().put(block);
        long checksum = checksum(unwritten.slice(start, WORDS * Long.BYTES), blocks());
        unwritten.putLong(start + WORDS * Long.BYTES, checksum);
        unwritten.position(start + BYTES);
        forced = false;
        if (!unwritten.hasRemaining()) {
            write();
        }
    }

    private static long checksum(ByteBuffer words, long block) {
        CRC32C checksum = new CRC32C();
        checksum.update(words);
        return block << Integer.SIZE | checksum.getValue();
    }

    private void write() {
        try {
            long blocks = unwritten.position() / BYTES;
            unwritten.flip();
            while (unwritten.hasRemaining()) {
                channel.write(unwritten, written * BYTES + unwritten.position());
            }
            unwritten.clear();
            written += blocks;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void read(long block, long[] into) {
        if (block >= written) {
            write();
        }
        try {
            read.clear();
            while (read.hasRemaining()) {
                if (channel.read(read, block * BYTES + read.position()) < 0) {
                    throw new Damaged("'" + file.getFileName() + "' is too short");
                }
            }
            read.flip();
            if (checksum(read.slice(0, WORDS * Long.BYTES), block)
                    != read.getLong(WORDS * Long.BYTES)) {
                throw new Damaged("block " + block + " of '" + file.getFileName() + "' is damaged");
            }
            read.asLongBuffer().get(into);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** What was appended stays, whatever happens to the machine. */
    void force() throws IOException {
        if (!forced) {
            write();
            unwritten = NOTHING;
            channel.force(false);
            forced = true;
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
