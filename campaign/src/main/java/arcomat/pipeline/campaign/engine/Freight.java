package arcomat.pipeline.campaign.engine;

import arcomat.pipeline.campaign.joint.JointFreight;
import arcomat.pipeline.file.ArchiveEntry;
import arcomat.sim.load.Program;
import arcomat.source.Sha256;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.HexFormat;
import java.util.Map;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;

/**
 * All that the runs of a campaign depend on: content, not paths, so that it can be sent to another
 * machine. Two campaigns with the same freight have the same rows.
 *
 * @param version of the tool: another one may see the same world otherwise
 * @param campaign text of the campaign
 * @param world text of the world
 * @param limited whether programs meet the limits of real bricks
 * @param patience what a run may take by the PC's clock
 * @param programs by what the world's text says of them
 * @param monitors columns of the table by the full names of classes that watch in these programs
 * @param joint what watches several of these programs for one requirement
 * @param coverage where these programs come to what runs may cover
 */
public record Freight(
        String version,
        String campaign,
        String world,
        boolean limited,
        Duration patience,
        Map<String, Program> programs,
        Map<String, String> monitors,
        JointFreight joint,
        ItemProbes coverage) {
    private static final String SETTINGS = "settings";
    private static final String CAMPAIGN = "campaign";
    private static final String WORLD = "world";
    private static final String PROGRAMS = "programs/";
    private static final String MONITORS = "monitors/";
    private static final String COVERAGE = "coverage/";

    public Freight {
        programs = Map.copyOf(programs);
        monitors = Map.copyOf(monitors);
    }

    /** Whose programs watch nothing, and of which nobody knows what they cover. */
    public Freight(
            String version,
            String campaign,
            String world,
            boolean limited,
            Duration patience,
            Map<String, Program> programs) {
        this(
                version,
                campaign,
                world,
                limited,
                patience,
                programs,
                Map.of(),
                JointFreight.NONE,
                ItemProbes.NONE);
    }

    /** Contents by name, in an order of their own. */
    private TreeMap<String, byte[]> entries() {
        TreeMap<String, byte[]> entries = new TreeMap<>();
        String settings =
                String.join(
                        "\n",
                        version,
                        "" + limited,
                        "" + patience.toNanos(),
                        "" + coverage.transitions());
        entries.put(SETTINGS, settings.getBytes(StandardCharsets.UTF_8));
        entries.put(CAMPAIGN, campaign.getBytes(StandardCharsets.UTF_8));
        entries.put(WORLD, world.getBytes(StandardCharsets.UTF_8));
        monitors.forEach(
                (type, column) ->
                        entries.put(MONITORS + type, column.getBytes(StandardCharsets.UTF_8)));
        entries.putAll(joint.entries());
        programs.forEach((key, program) -> pack(key, program, entries));
        coverage.ordered()
                .forEach(
                        (key, items) ->
                                entries.put(
                                        COVERAGE + spelt(key),
                                        items.text().getBytes(StandardCharsets.UTF_8)));
        return entries;
    }

    /** Packs an archive: the same freight gives the same bytes in every time zone, at any time. */
    public byte[] packed() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            for (Map.Entry<String, byte[]> each : entries().entrySet()) {
                zip.putNextEntry(ArchiveEntry.of(each.getKey()));
                zip.write(each.getValue());
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    /** What the world says of a program may hold anything, so it is spelt in hexadecimal. */
    private static String spelt(String key) {
        return HexFormat.of().formatHex(key.getBytes(StandardCharsets.UTF_8));
    }

    private static void pack(String key, Program program, Map<String, byte[]> entries) {
        String folder = PROGRAMS + spelt(key) + "/";
        entries.put(folder, program.mainClass().getBytes(StandardCharsets.UTF_8));
        program.classes().forEach((name, code) -> entries.put(folder + name, code));
    }

    /**
     * What was packed.
     *
     * @throws IOException where these are not the bytes of a freight
     */
    public static Freight unpacked(byte[] bytes) throws IOException {
        Map<String, byte[]> entries = entries(bytes);
        String[] settings = text(entries, SETTINGS).split("\n", -1);
        if (settings.length != 4) {
            throw new IOException("settings of " + settings.length + " lines");
        }
        return new Freight(
                settings[0],
                text(entries, CAMPAIGN),
                text(entries, WORLD),
                Boolean.parseBoolean(settings[1]),
                Duration.ofNanos(Long.parseLong(settings[2])),
                programs(entries),
                monitors(entries),
                JointFreight.of(entries),
                new ItemProbes(ItemProbes.number(settings[3]), coverage(entries)));
    }

    private static Map<String, ProgramItems> coverage(Map<String, byte[]> entries)
            throws IOException {
        Map<String, ProgramItems> programs = new TreeMap<>();
        for (String name : entries.keySet()) {
            if (name.startsWith(COVERAGE)) {
                String key = key(name.substring(COVERAGE.length()));
                programs.put(key, ProgramItems.read(text(entries, name)));
            }
        }
        return programs;
    }

    private static Map<String, String> monitors(Map<String, byte[]> entries) {
        Map<String, String> monitors = new TreeMap<>();
        entries.forEach(
                (name, column) -> {
                    if (name.startsWith(MONITORS)) {
                        String type = name.substring(MONITORS.length());
                        monitors.put(type, new String(column, StandardCharsets.UTF_8));
                    }
                });
        return monitors;
    }

    private static Map<String, byte[]> entries(byte[] bytes) throws IOException {
        Map<String, byte[]> entries = new TreeMap<>();
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(bytes))) {
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                entries.put(entry.getName(), zip.readAllBytes());
            }
        }
        return entries;
    }

    private static String text(Map<String, byte[]> entries, String name) throws IOException {
        byte[] bytes = entries.get(name);
        if (bytes == null) {
            throw new IOException("no " + name);
        }
        return new String(bytes, StandardCharsets.UTF_8);
    }

    private static Map<String, Program> programs(Map<String, byte[]> entries) {
        Map<String, String> mains = new TreeMap<>();
        Map<String, Map<String, byte[]>> classes = new TreeMap<>();
        entries.forEach(
                (name, content) -> {
                    if (name.startsWith(PROGRAMS)) {
                        int end = name.indexOf('/', PROGRAMS.length());
                        String key = key(name.substring(PROGRAMS.length(), end));
                        String within = name.substring(end + 1);
                        if (within.isEmpty()) {
                            mains.put(key, new String(content, StandardCharsets.UTF_8));
                        } else {
                            classes.computeIfAbsent(key, k -> new TreeMap<>()).put(within, content);
                        }
                    }
                });
        Map<String, Program> programs = new TreeMap<>();
        mains.forEach(
                (key, main) ->
                        programs.put(key, new Program(main, classes.getOrDefault(key, Map.of()))));
        return programs;
    }

    private static String key(String hexadecimal) {
        return new String(HexFormat.of().parseHex(hexadecimal), StandardCharsets.UTF_8);
    }

    /**
     * What tells it from every other one: 16 hexadecimal digits of a SHA-256. Of the contents, not
     * of the archive, which another Java may pack otherwise.
     */
    public String hash() {
        MessageDigest digest = Sha256.begin();
        entries()
                .forEach(
                        (name, content) -> {
                            String head = name + "\n" + content.length + "\n";
                            digest.update(head.getBytes(StandardCharsets.UTF_8));
                            digest.update(content);
                        });
        return HexFormat.of().formatHex(digest.digest(), 0, 8);
    }
}
