package arcomat.pipeline.explored;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.analysis.search.external.ExternalMemory.Volume;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** What was committed is found again as it was, or not at all. */
class BlockFolderTest {
    private static final int BLOCKS = 100;
    private static final long[] NOTES = {7, 8, 9};

    @TempDir private Path folder;

    private Path file;
    private long name;

    @BeforeEach
    void commit() throws IOException {
        try (BlockFolder memory = BlockFolder.in(folder)) {
            Volume volume = memory.create();
            for (int block = 0; block < BLOCKS; block++) {
                volume.append(block(block));
            }
            name = volume.name();
            memory.commit(NOTES, List.of(volume));
            file = folder.resolve(name + ".blocks");
            volume.append(block(-1));
            memory.create().append(block(-2));
        }
    }

    private static long[] block(long word) {
        long[] block = new long[BlockFile.WORDS];
        Arrays.fill(block, word);
        return block;
    }

    @Test
    void isFoundAgain() throws IOException {
        requireAll();
    }

    private void requireAll() throws IOException {
        try (BlockFolder memory = BlockFolder.in(folder)) {
            assertThat(memory.notes()).hasValue(NOTES);
            Volume volume = memory.open(name, BLOCKS);
            assertThat(volume.blocks()).isEqualTo(BLOCKS);
            for (int block = 0; block < BLOCKS; block++) {
                long[] read = new long[BlockFile.WORDS];
                volume.read(block, read);
                assertThat(read).isEqualTo(block(block));
            }
            try (Stream<Path> files = Files.list(folder)) {
                assertThat(files).hasSize(2);
            }
        }
    }

    @Test
    void tornWritesAreCutOff() throws IOException {
        Files.write(file, new byte[12_345], StandardOpenOption.APPEND);
        Files.write(folder.resolve(name + 1 + ".blocks"), new byte[99]);
        Files.write(folder.resolve("committed.tmp"), new byte[99]);
        requireAll();
    }

    @Test
    void missingBlocksAreNoticed() throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        Files.write(file, Arrays.copyOf(bytes, bytes.length - 1));
        try (BlockFolder memory = BlockFolder.in(folder)) {
            assertThatThrownBy(() -> memory.open(name, BLOCKS)).hasMessageContaining("too short");
        }
    }

    /** A block that is not what was written, and one in the place of another. */
    @Test
    void damagedBlocksAreNoticed() throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        int length = bytes.length / BLOCKS;
        bytes[3 * length + 77] ^= 4;
        System.arraycopy(bytes, 5 * length, bytes, 8 * length, length);
        Files.write(file, bytes);
        try (BlockFolder memory = BlockFolder.in(folder)) {
            Volume volume = memory.open(name, BLOCKS);
            long[] read = new long[BlockFile.WORDS];
            volume.read(5, read);
            assertThatThrownBy(() -> volume.read(3, read)).hasMessageContaining("block 3");
            assertThatThrownBy(() -> volume.read(8, read)).hasMessageContaining("block 8");
        }
    }

    @Test
    void whatIsCommittedIsNoticedToBeDamaged() throws IOException {
        Path committed = folder.resolve("committed");
        byte[] good = Files.readAllBytes(committed);
        for (int position = 0; position < good.length; position++) {
            byte[] bad = good.clone();
            bad[position] ^= 16;
            Files.write(committed, bad);
            assertThatThrownBy(() -> BlockFolder.in(folder)).hasMessageContaining("damaged");
            Files.write(committed, Arrays.copyOf(good, position));
            assertThatThrownBy(() -> BlockFolder.in(folder)).hasMessageContaining("damaged");
        }
    }
}
