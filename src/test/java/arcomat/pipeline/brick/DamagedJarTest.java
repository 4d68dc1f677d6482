package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Random;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;
import java.util.jar.JarOutputStream;

/** Jars whose classes are damaged run, fail in words, or are refused in words. */
class DamagedJarTest {
    private static final int JARS = 40;

    /** One of so many is damaged: two or three in a robot. */
    private static final int CLASSES = 15;

    @TempDir private Path folder;

    @Tag("slow")
    @Test
    void noDamageIsAnErrorOfTheTool() throws IOException {
        byte[] jar = CoffeeRobot.of("coffee.fetcher.Fetcher").jar();
        Random random = new Random(20261122);
        int refused = 0;
        for (int i = 0; i < JARS; i++) {
            Path damaged = Files.write(folder.resolve(i + ".jar"), damaged(jar, random));
            refused += isRefused(damaged) ? 1 : 0;
        }
        assertThat(refused).isBetween(JARS / 5, JARS - 1);
    }

    /** Some kilobytes that would fill the memory. */
    @Test
    void whatUnpacksToFarTooMuchIsRefused() throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JarOutputStream to = new JarOutputStream(bytes)) {
            to.putNextEntry(new JarEntry("p/Main.class"));
            for (int megabyte = 0; megabyte < 65; megabyte++) {
                to.write(new byte[1 << 20]);
            }
        }
        assertThat(bytes.size()).isLessThan(100_000);
        assertThatThrownBy(() -> JarReader.of("bomb.jar", bytes.toByteArray()))
                .isInstanceOf(WrongUse.class)
                .hasMessage(
                        "'bomb.jar' is no robot's jar: it holds more than 64 MB when it is"
                                + " unpacked");
    }

    private static boolean isRefused(Path jar) {
        RunJar task = new RunJar(jar.toString(), Optional.empty(), OptionalInt.of(1));
        try {
            RunJar.Result result = Session.in(Path.of(""), Progress.NONE).run(task);
            assertThat(result.run().isEmpty()).isEqualTo(!result.findings().isEmpty());
            return result.run().isEmpty();
        } catch (WrongUse e) {
            return true;
        }
    }

    /** Of one class or the other some bytes are others, or its end is missing. */
    private static byte[] damaged(byte[] jar, Random random) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JarInputStream from = new JarInputStream(new ByteArrayInputStream(jar));
                JarOutputStream to = new JarOutputStream(bytes, from.getManifest())) {
            for (JarEntry entry = from.getNextJarEntry(); entry != null; ) {
                to.putNextEntry(new JarEntry(entry.getName()));
                byte[] file = from.readAllBytes();
                to.write(random.nextInt(CLASSES) == 0 ? damage(file, random) : file);
                entry = from.getNextJarEntry();
            }
        }
        return bytes.toByteArray();
    }

    private static byte[] damage(byte[] file, Random random) {
        if (file.length == 0 || random.nextInt(4) == 0) {
            return Arrays.copyOf(file, random.nextInt(file.length + 1));
        }
        byte[] other = file.clone();
        for (int i = random.nextInt(3); i >= 0; i--) {
            other[random.nextInt(other.length)] = (byte) random.nextInt();
        }
        return other;
    }
}
