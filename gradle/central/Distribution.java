import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** The parts of a Gradle installation before they are written: the entries of every jar by path. */
final class Distribution {
    /** Ends the name of the entry that lists what a module depends on. */
    static final String MARKER = "-classpath.properties";

    final Map<String, Map<String, byte[]>> modules = new LinkedHashMap<>();

    /** Libraries that get a jar of their own, without their versions. */
    final Map<String, Map<String, byte[]>> libraries = new LinkedHashMap<>();

    /** All other libraries. */
    final Map<String, byte[]> thirdParty = new LinkedHashMap<>();

    String version;

    Map<String, byte[]> module(String name) {
        return modules.computeIfAbsent(name, n -> new LinkedHashMap<>());
    }

    Map<String, byte[]> library(String name) {
        return libraries.computeIfAbsent(name, n -> new LinkedHashMap<>());
    }

    Properties dependencies(String module) throws IOException {
        return properties(modules.get(module).getOrDefault(module + MARKER, new byte[0]));
    }

    /** The names of the library jars that modules ask for. */
    Set<String> libraryJars() throws IOException {
        Set<String> jars = new TreeSet<>();
        for (String module : modules.keySet()) {
            jars.addAll(names(dependencies(module), "runtime"));
        }
        return jars;
    }

    /** The modules that belong into the folder of plugins. */
    Set<String> plugins() throws IOException {
        Set<String> plugins = new LinkedHashSet<>();
        for (Map<String, byte[]> module : modules.values()) {
            for (String kind : new String[] {"plugins", "implementation-plugins"}) {
                byte[] list = module.get("gradle-" + kind + ".properties");
                if (list != null) {
                    plugins.addAll(names(properties(list), "plugins"));
                }
            }
        }
        return plugins;
    }

    static Properties properties(byte[] content) throws IOException {
        Properties properties = new Properties();
        properties.load(new ByteArrayInputStream(content));
        return properties;
    }

    /** The names of a comma-separated property, in their order. */
    static Set<String> names(Properties properties, String key) {
        return Arrays.stream(properties.getProperty(key, "").split(","))
                .filter(name -> !name.isEmpty())
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
