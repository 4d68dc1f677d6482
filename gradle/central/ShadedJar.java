import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/**
 * Takes the shaded jar apart. Its entries follow each other module by module, each module ended by
 * its marker; the entries of libraries stand anywhere between them.
 */
final class ShadedJar {
    private static final String SERVICES = "META-INF/services/";

    /** Resources at the top level that are Gradle's own; all others came with libraries. */
    private static final Set<String> OWN_RESOURCES =
            Set.of(
                    "release-features.txt",
                    "instrumented-super-types.properties",
                    "upgraded-properties.json");

    /**
     * Libraries that need a jar of their own, by package, longer ones first: Ant is loaded apart
     * from the rest, and the test frameworks must never shadow those that a build brings along.
     */
    private static final String[][] LIBRARY_OF_PACKAGE = {
        {"org/apache/tools/ant/", "ant"},
        {"org/junit/platform/commons/", "junit-platform-commons"},
        {"org/junit/platform/engine/", "junit-platform-engine"},
        {"org/junit/platform/launcher/", "junit-platform-launcher"},
        {"org/opentest4j/", "opentest4j"},
        {"org/junit/", "junit"},
        {"junit/", "junit"},
        {"org/hamcrest/", "hamcrest-core"},
        {"org/testng/", "testng"},
        {"org/slf4j/bridge/", "jul-to-slf4j"},
        {"org/slf4j/", "slf4j-api"}
    };

    private final Distribution distribution;
    private final Map<String, String> moduleOfEntry = new HashMap<>();

    /** Service files by path; those of all modules are merged in the shaded jar. */
    private final Map<String, String> services = new LinkedHashMap<>();

    private ShadedJar(Distribution distribution) {
        this.distribution = distribution;
    }

    static void read(Path jar, Distribution distribution) throws IOException {
        ShadedJar shaded = new ShadedJar(distribution);
        try (ZipFile zip = new ZipFile(jar.toFile())) {
            distribution.version = version(zip);
            shaded.readEntries(zip);
        }
        shaded.returnServicesToTheirModules();
    }

    /** A jar that is one module and was never merged with others, such as the test kit. */
    static void readModule(String name, Path jar, Distribution distribution) throws IOException {
        try (ZipFile zip = new ZipFile(jar.toFile())) {
            for (ZipEntry entry : Collections.list(zip.entries())) {
                if (!entry.isDirectory() && !entry.getName().startsWith("META-INF/MANIFEST")) {
                    distribution.module(name).put(entry.getName(), content(zip, entry));
                }
            }
        }
    }

    private static String version(ZipFile zip) throws IOException {
        ZipEntry receipt = zip.getEntry("org/gradle/build-receipt.properties");
        return Distribution.properties(content(zip, receipt)).getProperty("versionNumber");
    }

    private void readEntries(ZipFile zip) throws IOException {
        Map<String, byte[]> open = new LinkedHashMap<>(); // entries whose marker is yet to come
        String module = null;
        for (ZipEntry entry : Collections.list(zip.entries())) {
            String name = entry.getName();
            if (entry.isDirectory() || isLeftOut(name)) {
                continue;
            }
            byte[] content = content(zip, entry);
            if (name.startsWith(SERVICES)) {
                services.put(Shading.undo(name), Shading.undo(text(content)));
            } else if (isLibrary(name)) {
                String path = Shading.undo(name);
                jarOfLibrary(path).putIfAbsent(path, content);
            } else if (name.endsWith(Distribution.MARKER)) {
                open.put(name, content);
                module = name.substring(0, name.length() - Distribution.MARKER.length());
                closeModule(module, open);
            } else if (module != null && open.isEmpty() && !isClass(name)) {
                distribution.module(module).put(name, content); // right behind the marker
            } else {
                open.put(name, content);
            }
        }
        distribution.thirdParty.putAll(open);
    }

    private void closeModule(String name, Map<String, byte[]> entries) {
        entries.keySet().forEach(path -> moduleOfEntry.put(path, name));
        distribution.module(name).putAll(entries);
        entries.clear();
    }

    /** Every line of a merged service file belongs to the module that has the class. */
    private void returnServicesToTheirModules() {
        services.forEach(
                (path, lines) -> {
                    for (String line : lines.split("\\R")) {
                        String provider = line.replaceAll("#.*", "").trim();
                        if (!provider.isEmpty()) {
                            jarOfClass(provider)
                                    .merge(
                                            path,
                                            Distribution.bytes(provider + "\n"),
                                            ShadedJar::joined);
                        }
                    }
                });
    }

    private Map<String, byte[]> jarOfClass(String name) {
        String module = moduleOfEntry.get(name.replace('.', '/') + ".class");
        return module == null ? distribution.thirdParty : distribution.module(module);
    }

    private Map<String, byte[]> jarOfLibrary(String path) {
        for (String[] library : LIBRARY_OF_PACKAGE) {
            if (path.startsWith(library[0])) {
                return distribution.library(library[1]);
            }
        }
        return distribution.thirdParty;
    }

    /** Signatures and the like, providers for the whole JDK, and what comes as a jar of its own. */
    private static boolean isLeftOut(String name) {
        return name.equals("META-INF/MANIFEST.MF")
                || name.endsWith("module-info.class")
                || name.matches("META-INF/([^/]+\\.(SF|RSA|DSA|EC)|INDEX\\.LIST)")
                || Stream.of(
                                "META-INF/maven/",
                                "META-INF/versions/",
                                SERVICES + "java",
                                Shading.PATH + "META-INF/",
                                Shading.PATH + "org/jetbrains/kotlin/",
                                "groovy/",
                                "org/codehaus/groovy/",
                                "org/apache/groovy/")
                        .anyMatch(name::startsWith);
    }

    private static boolean isLibrary(String name) {
        if (name.startsWith(Shading.PATH)) {
            return true;
        }
        if (name.indexOf('/') < 0) {
            return !(name.startsWith("gradle-")
                    || name.endsWith("default-imports.txt")
                    || name.endsWith("api-mapping.txt")
                    || OWN_RESOURCES.contains(name));
        }
        return !name.startsWith("org/gradle/")
                && !name.startsWith("org/slf4j/impl/")
                && !name.startsWith("META-INF/gradle-plugins/");
    }

    private static boolean isClass(String name) {
        return name.endsWith(".class");
    }

    private static byte[] content(ZipFile zip, ZipEntry entry) throws IOException {
        try (InputStream in = zip.getInputStream(entry)) {
            byte[] content = in.readAllBytes();
            return isClass(entry.getName()) ? Shading.undoInClass(content) : content;
        }
    }

    private static String text(byte[] content) {
        return new String(content, StandardCharsets.UTF_8);
    }

    private static byte[] joined(byte[] first, byte[] second) {
        byte[] both = Arrays.copyOf(first, first.length + second.length);
        System.arraycopy(second, 0, both, first.length, second.length);
        return both;
    }
}
