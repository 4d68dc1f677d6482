package arcomat.pipeline.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.WrongUse;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.world.Recording;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Runs of the shipped worlds are what they have been, bit for bit: each line of the file is a
 * world, limits, a seed and the hash of the recording. Whoever makes runs faster must not change
 * them; whoever means to change them has {@code -Dtranscripts.update=true} write the file anew.
 */
class TracesTest {
    private static final Path FILE = Path.of("world/src/test/resources/world/traces.txt");
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");
    private static final int FEW = 6;
    private static final int AT_ONCE = 4;
    private static final int DIGITS = 32;

    private record Trace(String world, boolean counted, long seed, String hash) {
        static Trace of(String line) {
            String[] words = line.split(" ");
            return new Trace(
                    words[0], words[1].equals("counted"), Long.parseLong(words[2]), words[3]);
        }

        @Override
        public String toString() {
            return "%s %s %d %s".formatted(world, counted ? "counted" : "free", seed, hash);
        }

        /** The same run, with what it is now. */
        Trace again(PreparedWorld prepared) {
            Limits limits = counted ? Limits.OF_THE_BRICK : Limits.NONE;
            Recording recording = prepared.run(seed, Laboratory.PATIENCE, limits);
            return new Trace(world, counted, seed, TracesTest.hash(recording));
        }
    }

    /** Numbers are written so that they can be read back: another last bit is another text. */
    private static String hash(Recording recording) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            for (Object part :
                    List.of(
                            recording.frames(),
                            recording.events(),
                            recording.failures(),
                            recording.blind(),
                            recording.late())) {
                // As it was written before there were things.
                String text = part.toString().replace(", things=[]]", "]");
                digest.update(text.getBytes(StandardCharsets.UTF_8));
            }
            return HexFormat.of().formatHex(digest.digest()).substring(0, DIGITS);
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java has it", e);
        }
    }

    @Tag("slow")
    @Test
    void theMeetingIsWhatItWas() throws IOException, WrongUse {
        check(Shipped.MEETING, FEW);
    }

    @Test
    @Tag("slow")
    void theMeetingIsWhatItWasWhateverTheSeed() throws IOException, WrongUse {
        check(Shipped.MEETING, Integer.MAX_VALUE);
    }

    @Test
    @Tag("slow")
    void theServiceIsWhatItWas() throws IOException, WrongUse {
        check(Shipped.SERVICE, Integer.MAX_VALUE);
    }

    /** Campaigns run many at once, with the same programs. */
    @Tag("slow")
    @Test
    void runsAtTheSameTimeAreWhatTheyWere() throws Exception {
        List<Trace> traces = Files.readAllLines(FILE).stream().map(Trace::of).limit(FEW).toList();
        PreparedWorld world = Shipped.world(Shipped.MEETING);
        ExecutorService threads = Executors.newFixedThreadPool(AT_ONCE);
        List<Future<Trace>> runs = new ArrayList<>();
        for (int i = 0; i < AT_ONCE; i++) {
            traces.forEach(trace -> runs.add(threads.submit(() -> trace.again(world))));
        }
        for (int i = 0; i < runs.size(); i++) {
            assertThat(runs.get(i).get()).isEqualTo(traces.get(i % traces.size()));
        }
        threads.shutdown();
    }

    private static void check(String name, int most) throws IOException, WrongUse {
        List<Trace> all = Files.readAllLines(FILE).stream().map(Trace::of).toList();
        PreparedWorld world = Shipped.world(name);
        List<Trace> before = new ArrayList<>();
        List<Trace> now = new ArrayList<>();
        for (Trace trace : all) {
            if (trace.world().equals(name) && before.size() < most) {
                before.add(trace);
                now.add(trace.again(world));
            }
        }
        if (UPDATE) {
            write(all, now);
        }
        assertThat(now).isNotEmpty().isEqualTo(before);
    }

    private static void write(List<Trace> all, List<Trace> now) throws IOException {
        List<String> lines = new ArrayList<>();
        for (Trace trace : all) {
            Trace newer =
                    now.stream()
                            .filter(each -> each.world().equals(trace.world()))
                            .filter(each -> each.counted() == trace.counted())
                            .filter(each -> each.seed() == trace.seed())
                            .findFirst()
                            .orElse(trace);
            lines.add(newer.toString());
        }
        Files.write(FILE, lines);
    }
}
