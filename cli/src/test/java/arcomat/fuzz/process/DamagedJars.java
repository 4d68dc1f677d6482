package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;

/** Robots' jars: damaged ones, and whole ones with damaged classes. */
final class DamagedJars implements Kind {
    private static final Set<Integer> CHECKED = Set.of(0, 1, 2);
    private static final Set<Integer> RUN = Set.of(0, 1, 2, 3);

    private final List<byte[]> jars;
    private final byte[] script;

    DamagedJars(Seeds seeds) throws IOException {
        jars = jarsOf(seeds);
        script = java.nio.file.Files.readAllBytes(Seeds.COFFEE.resolve("scripts/fetcher.script"));
    }

    static List<byte[]> jarsOf(Seeds seeds) {
        return seeds.made().entrySet().stream()
                .filter(file -> file.getKey().endsWith(".jar"))
                .map(Map.Entry::getValue)
                .toList();
    }

    @Override
    public String name() {
        return "jars";
    }

    @Override
    public Input draw(Dice dice) {
        byte[] jar = dice.one(jars);
        byte[] damaged = dice.below(4) == 0 ? new ByteDamage(dice).apply(jar) : inside(jar, dice);
        SortedMap<String, byte[]> files =
                new TreeMap<>(Map.of("r.jar", damaged, "s.script", script));
        return new Input(files, List.of(call(dice.below(4))));
    }

    private static Call call(int which) {
        return switch (which) {
            case 0 -> Call.of(CHECKED, "check-brick", "--jar", "r.jar");
            case 1 ->
                    Call.of(RUN, "run-brick", "--jar", "r.jar", "--timeout", "4")
                            .and("--report", "page")
                            .writing("page");
            default ->
                    Call.of(RUN, "run-brick", "--jar", "r.jar", "--timeout", "4")
                            .and("--script", "s.script", "--trace", which == 2 ? "json" : "csv");
        };
    }

    /** One or two of the entries are damaged, have another's content or name, or are gone. */
    private static byte[] inside(byte[] jar, Dice dice) {
        Map<String, byte[]> entries = entries(jar);
        for (int i = dice.below(2); i >= 0; i--) {
            List<String> names = new ArrayList<>(entries.keySet());
            String name = dice.one(names);
            switch (dice.below(12)) {
                case 0 -> entries.remove(name);
                case 1 -> entries.put(name, entries.get(dice.one(names)));
                case 2 -> entries.put("x/" + name, entries.remove(name));
                default -> entries.put(name, new ByteDamage(dice).apply(entries.get(name)));
            }
        }
        return jar(entries);
    }

    private static Map<String, byte[]> entries(byte[] jar) {
        Map<String, byte[]> entries = new TreeMap<>();
        try (ZipInputStream from = new ZipInputStream(new ByteArrayInputStream(jar))) {
            for (ZipEntry e = from.getNextEntry(); e != null; e = from.getNextEntry()) {
                if (!e.isDirectory()) {
                    entries.put(e.getName(), from.readAllBytes());
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return entries;
    }

    private static byte[] jar(Map<String, byte[]> entries) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream to = new ZipOutputStream(bytes)) {
            for (Map.Entry<String, byte[]> entry : entries.entrySet()) {
                ZipEntry header = new ZipEntry(entry.getKey());
                header.setTime(0);
                to.putNextEntry(header);
                to.write(entry.getValue());
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }
}
