import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.stream.Collectors;

/** Writes the folder of an installation. */
final class Installation {
    private static final String LAUNCHER = "gradle-launcher";

    private final Distribution distribution;
    private final Path home;
    private final Path lib;

    Installation(Distribution distribution, Path home) {
        this.distribution = distribution;
        this.home = home;
        this.lib = home.resolve("lib");
    }

    /**
     * @param jars the folder of the jars that were fetched
     */
    void write(Path jars) throws IOException {
        Set<String> libraryJars = distribution.libraryJars();
        pointModulesToThirdPartyJar();
        writeModules();
        writeLibraries(libraryJars, jars);
        writeStartScript();
        writeSettings();
    }

    /** Libraries without a jar of their own are in one jar, on which each module depends. */
    private void pointModulesToThirdPartyJar() throws IOException {
        for (String name : distribution.modules.keySet()) {
            Properties dependencies = distribution.dependencies(name);
            Set<String> runtime = Distribution.names(dependencies, "runtime");
            runtime.add(thirdPartyJar());
            String text = "projects=" + dependencies.getProperty("projects", "") + "\n";
            text += "runtime=" + String.join(",", runtime) + "\n";
            String optional = dependencies.getProperty("optional");
            text += optional == null ? "" : "optional=" + optional + "\n";
            distribution.module(name).put(name + Distribution.MARKER, Distribution.bytes(text));
        }
    }

    private void writeModules() throws IOException {
        Set<String> plugins = distribution.plugins();
        Path pluginFolder = Files.createDirectories(lib.resolve("plugins"));
        String all =
                distribution.modules.keySet().stream()
                        .filter(name -> !plugins.contains(name) && !name.equals(LAUNCHER))
                        .map(this::jarName)
                        .collect(Collectors.joining(" ", "", " " + thirdPartyJar()));
        for (String name : distribution.modules.keySet()) {
            Path folder = plugins.contains(name) ? pluginFolder : lib;
            String classPath = name.equals(LAUNCHER) ? all : null;
            Jar.write(folder.resolve(jarName(name)), distribution.module(name), classPath);
        }
        Jar.write(lib.resolve(thirdPartyJar()), distribution.thirdParty, null);
    }

    /**
     * A jar under every name that modules ask for: the real one if it was fetched, else what the
     * shaded jar had of it, else one that points to the jar of all libraries.
     */
    private void writeLibraries(Set<String> libraryJars, Path fetched) throws IOException {
        for (String jar : libraryJars) {
            Map<String, byte[]> entries = distribution.libraries.remove(withoutVersion(jar));
            if (Files.exists(fetched.resolve(jar))) {
                Files.copy(fetched.resolve(jar), lib.resolve(jar));
            } else if (entries != null) {
                Jar.write(lib.resolve(jar), entries, null);
            } else {
                String classPath = jar.startsWith("ant-") ? null : thirdPartyJar();
                Jar.write(lib.resolve(jar), Map.of(), classPath);
            }
        }
        if (!distribution.libraries.isEmpty()) {
            throw new IOException("nobody asks for " + distribution.libraries.keySet());
        }
    }

    private static String withoutVersion(String jar) {
        return jar.replaceFirst("-\\d.*", "");
    }

    private void writeStartScript() throws IOException {
        Path script = Files.createDirectories(home.resolve("bin")).resolve("gradle");
        Files.writeString(
                script,
                """
                #!/bin/sh
                APP_HOME=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd -P)
                if [ -n "$JAVA_HOME" ]; then JAVACMD=$JAVA_HOME/bin/java; else JAVACMD=java; fi
                exec "$JAVACMD" -Xmx64m -Xms64m $JAVA_OPTS $GRADLE_OPTS -Dorg.gradle.appname=gradle \\
                    -classpath "$APP_HOME/lib/LAUNCHER" org.gradle.launcher.GradleMain "$@"
                """
                        .replace("LAUNCHER", jarName(LAUNCHER)));
        script.toFile().setExecutable(true);
    }

    /** Switches off what needs absent parts: the agent and incremental compilation. */
    private void writeSettings() throws IOException {
        Files.writeString(
                home.resolve("gradle.properties"),
                "org.gradle.internal.instrumentation.agent=false\n");
        Files.writeString(
                Files.createDirectories(home.resolve("init.d")).resolve("assembled.gradle"),
                """
                allprojects {
                    tasks.withType(JavaCompile).configureEach { options.incremental = false }
                }
                """);
    }

    private String jarName(String module) {
        return module + "-" + distribution.version + ".jar";
    }

    private String thirdPartyJar() {
        return jarName("gradle-thirdparty");
    }
}
