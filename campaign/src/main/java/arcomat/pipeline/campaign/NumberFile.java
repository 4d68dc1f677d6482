package arcomat.pipeline.campaign;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Spliterator;
import java.util.Spliterators.AbstractDoubleSpliterator;
import java.util.function.DoubleConsumer;
import java.util.stream.DoubleStream;
import java.util.stream.StreamSupport;

/** Reads numbers of eight bytes each from a file, one after the other. */
final class NumberFile extends AbstractDoubleSpliterator {
    private static final int BUFFER = 1 << 16;

    private final SeekableByteChannel channel;
    private final ByteBuffer buffer = ByteBuffer.allocate(BUFFER).limit(0);

    private NumberFile(SeekableByteChannel channel, long numbers) {
        super(numbers, Spliterator.ORDERED | Spliterator.NONNULL);
        this.channel = channel;
    }

    /** All numbers of a file; to be closed. */
    static DoubleStream stream(Path file) {
        try {
            SeekableByteChannel channel = Files.newByteChannel(file);
            NumberFile numbers = new NumberFile(channel, channel.size() / Double.BYTES);
            return StreamSupport.doubleStream(numbers, false).onClose(numbers::close);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private void close() {
        try {
            channel.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public boolean tryAdvance(DoubleConsumer action) {
        if (buffer.remaining() < Double.BYTES && !fill()) {
            return false;
        }
        action.accept(buffer.getDouble());
        return true;
    }

    @Override
    public void forEachRemaining(DoubleConsumer action) {
        while (buffer.remaining() >= Double.BYTES || fill()) {
            action.accept(buffer.getDouble());
        }
    }

    /** Whether there is a whole number then. */
    private boolean fill() {
        buffer.compact();
        try {
            while (buffer.position() < Double.BYTES && channel.read(buffer) >= 0) {
                // A channel may give less than there is room for.
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        buffer.flip();
        return buffer.remaining() >= Double.BYTES;
    }
}
