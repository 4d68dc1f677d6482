import java.io.*;
import java.nio.charset.StandardCharsets;
import java.nio.file.*;
import java.util.*;
import java.util.zip.*;

/**
 * Rebuilds a runnable Gradle installation from the Maven Central artifact
 * dev.gradleplugins:gradle-api (the shaded "gradleApi()" jar of one release).
 *
 * <p>The shaded jar is the concatenation of every Gradle module jar and every third-party jar of
 * the distribution; third-party packages were moved below org.gradle.internal.impldep. This program
 * undoes both steps: 1. strip the prefix in constant pools and paths, 2. cut the entry list back
 * into gradle-<module>-<version>.jar at each <module>-classpath.properties marker.
 *
 * <p>usage: java AssembleGradle.java LOCKFILE JAR_DIR GRADLE_HOME (lock file: sha256sum format)
 */
public class AssembleGradle {
    static final String P = "org/gradle/internal/impldep/", D = "org.gradle.internal.impldep.";
    static final String SFX = "-classpath.properties";

    static class Out { // one jar being collected
        final String name;
        final Map<String, byte[]> entries = new LinkedHashMap<>();

        Out(String name) {
            this.name = name;
        }
    }

    public static void main(String[] a) throws Exception {
        long t0 = System.nanoTime();
        Path deps = Paths.get(a[1]), home = Paths.get(a[2]), out = Paths.get(a[2] + ".part");
        verify(Paths.get(a[0]), deps);
        Path fat = find(deps, "gradle-api-"), testkit = find(deps, "gradle-test-kit-");
        Map<String, Out> modules = new LinkedHashMap<>();
        Out third = new Out("third");
        Map<String, Out> routed =
                new LinkedHashMap<>(); // third-party code that must sit in a jar of its own
        Map<String, String> owner = new HashMap<>(); // class path -> module
        Map<String, byte[]> services = new LinkedHashMap<>();
        Map<String, byte[]> pending = new LinkedHashMap<>();
        delete(out);
        String version = null, last = null;
        try (ZipFile z = new ZipFile(fat.toFile())) {
            Properties receipt = new Properties();
            receipt.load(z.getInputStream(z.getEntry("org/gradle/build-receipt.properties")));
            version = receipt.getProperty("versionNumber");
            for (Enumeration<? extends ZipEntry> en = z.entries(); en.hasMoreElements(); ) {
                ZipEntry e = en.nextElement();
                String n = e.getName();
                if (e.isDirectory() || drop(n)) continue;
                byte[] b = z.getInputStream(e).readAllBytes();
                boolean cls = n.endsWith(".class");
                if (cls) b = unshade(b);
                if (n.startsWith("META-INF/services/java"))
                    continue; // JDK-wide providers of sftp/script libraries
                if (n.startsWith("META-INF/services/")) {
                    services.put(
                            strip(n),
                            strip(new String(b, StandardCharsets.UTF_8))
                                    .getBytes(StandardCharsets.UTF_8));
                } else if (n.startsWith(P) || thirdParty(n)) {
                    String r = route(strip(n));
                    (r == null ? third : routed.computeIfAbsent(r, Out::new))
                            .entries.putIfAbsent(strip(n), b);
                } else if (n.endsWith(SFX)) {
                    last = n.substring(0, n.length() - SFX.length());
                    Out o = modules.computeIfAbsent(last, Out::new);
                    o.entries.putAll(pending);
                    o.entries.put(n, b);
                    for (String c : pending.keySet()) owner.put(c, last);
                    pending.clear();
                } else if (cls || last == null) {
                    pending.put(n, b);
                } else if (pending.isEmpty()) { // resource right behind its marker
                    modules.get(last).entries.put(n, b);
                } else pending.put(n, b);
            }
        }
        if (!pending.isEmpty()) System.err.println("unowned tail entries: " + pending.size());
        third.entries.putAll(pending);
        // the test kit is a separate, already thin artifact
        Out tk = modules.computeIfAbsent("gradle-test-kit", Out::new);
        try (ZipFile z = new ZipFile(testkit.toFile())) {
            for (ZipEntry e : Collections.list(z.entries()))
                if (!e.isDirectory() && !e.getName().startsWith("META-INF/MANIFEST"))
                    tk.entries.put(
                            e.getName(),
                            e.getName().endsWith(".class")
                                    ? unshade(z.getInputStream(e).readAllBytes())
                                    : z.getInputStream(e).readAllBytes());
        }
        // service files were merged: hand every line back to the module that owns the class
        for (Map.Entry<String, byte[]> s : services.entrySet())
            for (String line : new String(s.getValue(), StandardCharsets.UTF_8).split("\\R")) {
                String c = line.replaceAll("#.*", "").trim();
                if (c.isEmpty()) continue;
                String m = owner.get(c.replace('.', '/') + ".class");
                Out o = m == null ? third : modules.get(m);
                o.entries.merge(
                        s.getKey(),
                        (c + "\n").getBytes(StandardCharsets.UTF_8),
                        AssembleGradle::cat);
            }
        // names referred to but not shipped in the shaded jar become empty modules
        Set<String> runtime = new TreeSet<>(),
                wanted =
                        new TreeSet<>(
                                List.of(
                                        "gradle-installation-beacon",
                                        "gradle-instrumentation-agent",
                                        "gradle-kotlin-dsl",
                                        "gradle-kotlin-dsl-provider-plugins",
                                        "gradle-kotlin-dsl-tooling-builders",
                                        "gradle-java-compiler-plugin"));
        for (Out o : modules.values()) {
            Properties p = props(o);
            Collections.addAll(wanted, p.getProperty("projects", "").split(","));
            Collections.addAll(runtime, p.getProperty("runtime", "").split(","));
        }
        Set<String> plugins = new LinkedHashSet<>();
        for (Out o : modules.values())
            for (String f :
                    List.of(
                            "gradle-plugins.properties",
                            "gradle-implementation-plugins.properties"))
                if (o.entries.containsKey(f)) {
                    Properties p = new Properties();
                    p.load(new ByteArrayInputStream(o.entries.get(f)));
                    Collections.addAll(plugins, p.getProperty("plugins").split(","));
                }
        wanted.addAll(plugins);
        wanted.remove("");
        runtime.remove("");
        for (String w : wanted)
            if (!modules.containsKey(w)) {
                System.err.println("stub module " + w);
                modules.put(w, new Out(w));
            }
        for (Out o : modules.values())
            o.entries.putIfAbsent(o.name + SFX, "projects=\nruntime=\n".getBytes());
        modules.get("gradle-installation-beacon")
                .entries
                .put(
                        "org/gradle/internal/installation/beacon/InstallationBeacon.class",
                        emptyClass("org/gradle/internal/installation/beacon/InstallationBeacon"));
        for (String r : runtime)
            if (r.startsWith("kotlin-stdlib-"))
                modules.get("gradle-kotlin-dsl")
                        .entries
                        .put(
                                "gradle-kotlin-dsl-versions.properties",
                                ("kotlin=" + r.replaceAll("kotlin-stdlib-|\\.jar", "") + "\n")
                                        .getBytes());
        // the javac plugin that feeds incremental compilation is not in the shaded jar: a
        // pass-through stands in for it
        modules.get("gradle-java-compiler-plugin")
                .entries
                .putAll(
                        compile(
                                "org.gradle.internal.compiler.java",
                                "IncrementalCompileTask",
                                String.join(
                                        "\n",
                                        "package org.gradle.internal.compiler.java;",
                                        "import java.io.File; import java.util.*; import"
                                            + " java.util.function.*; import"
                                            + " javax.tools.JavaCompiler;",
                                        "public class IncrementalCompileTask implements"
                                            + " JavaCompiler.CompilationTask {",
                                        "  private final JavaCompiler.CompilationTask task;",
                                        "  public"
                                            + " IncrementalCompileTask(JavaCompiler.CompilationTask"
                                            + " task, Function<File, Optional<String>> a,"
                                            + " Consumer<String> b,",
                                        "      Consumer<Map<String, Set<String>>> c,"
                                            + " BiConsumer<String, String> d, BiConsumer<String,"
                                            + " String> e) { this.task = task; }",
                                        "  public void addModules(Iterable<String> m) { throw new"
                                            + " UnsupportedOperationException(); }",
                                        "  public void setProcessors(Iterable<? extends"
                                            + " javax.annotation.processing.Processor> p) {"
                                            + " task.setProcessors(p); }",
                                        "  public void setLocale(Locale l) { task.setLocale(l); }",
                                        "  public Boolean call() { return task.call(); }",
                                        "}")));
        // third-party: one real jar (ant/groovy/... apart) + empty name holders
        String tp = "gradle-thirdparty-" + version + ".jar";
        for (Out o : modules.values()) {
            Properties p = props(o);
            String rt = p.getProperty("runtime", "");
            StringBuilder sb =
                    new StringBuilder(
                            "projects="
                                    + p.getProperty("projects", "")
                                    + "\nruntime="
                                    + rt
                                    + (rt.isEmpty() ? "" : ",")
                                    + tp
                                    + "\n");
            if (p.getProperty("optional") != null)
                sb.append("optional=").append(p.getProperty("optional")).append('\n');
            o.entries.put(o.name + SFX, sb.toString().getBytes());
        }
        Path lib = out.resolve("lib");
        Files.createDirectories(lib.resolve("plugins"));
        Files.createDirectories(out.resolve("bin"));
        Files.createDirectories(out.resolve("init.d"));
        StringBuilder cp = new StringBuilder();
        for (Out o : modules.values())
            if (!plugins.contains(o.name) && !o.name.equals("gradle-launcher"))
                cp.append(o.name).append('-').append(version).append(".jar ");
        cp.append(tp);
        for (Out o : modules.values()) {
            Path dir = plugins.contains(o.name) ? lib.resolve("plugins") : lib;
            write(
                    dir.resolve(o.name + "-" + version + ".jar"),
                    o.entries,
                    o.name.equals("gradle-launcher") ? cp.toString() : null);
        }
        write(lib.resolve(tp), third.entries, null);
        int real = 0;
        for (String r : runtime)
            if (Files.exists(deps.resolve(r))) {
                Files.copy(deps.resolve(r), lib.resolve(r));
                real++;
                routed.remove(r.replaceFirst("-\\d.*", ""));
            } else {
                Out o = routed.remove(r.replaceFirst("-\\d.*", ""));
                if (o != null) write(lib.resolve(r), o.entries, null);
                else write(lib.resolve(r), Map.of(), r.startsWith("ant-") ? null : tp);
            }
        if (!routed.isEmpty()) throw new IOException("no jar name for " + routed.keySet());
        System.err.printf(
                "Gradle %s: %d modules (%d plugins), %d third-party entries, %d real jars, %d name"
                    + " holders, %.1f s%n",
                version,
                modules.size(),
                plugins.size(),
                third.entries.size(),
                real,
                runtime.size() - real,
                (System.nanoTime() - t0) / 1e9);
        Files.writeString(
                out.resolve("bin/gradle"),
                "#!/bin/sh\n"
                    + "APP_HOME=$(cd \"$(dirname \"$(readlink -f \"$0\")\")/..\" && pwd -P)\n"
                    + "if [ -n \"$JAVA_HOME\" ]; then JAVACMD=$JAVA_HOME/bin/java; else"
                    + " JAVACMD=java; fi\n"
                    + "exec \"$JAVACMD\" -Xmx64m -Xms64m $JAVA_OPTS $GRADLE_OPTS"
                    + " -Dorg.gradle.appname=gradle -classpath \"$APP_HOME/lib/gradle-launcher-"
                        + version
                        + ".jar\" org.gradle.launcher.GradleMain \"$@\"\n");
        out.resolve("bin/gradle").toFile().setExecutable(true);
        Files.writeString(
                out.resolve("gradle.properties"),
                "org.gradle.internal.instrumentation.agent=false\n");
        Files.writeString(
                out.resolve("init.d/assembled.gradle"),
                "// the javac plugin behind incremental compilation is not part of the shaded jar\n"
                    + "allprojects { tasks.withType(JavaCompile).configureEach {"
                    + " options.incremental = false } }\n");
        Files.move(out, home);
        delete(deps); // 190 MB that are not needed any more
    }

    /** Every jar of the lock file must be there with the recorded checksum. */
    static void verify(Path lock, Path deps) throws Exception {
        for (String line : Files.readAllLines(lock)) {
            if (line.isBlank() || line.startsWith("#")) continue;
            String[] f = line.split("\\s+");
            String got = sha256(deps.resolve(f[1]));
            if (!got.equals(f[0]))
                throw new IOException("checksum of " + f[1] + " is " + got + ", expected " + f[0]);
        }
    }

    static String sha256(Path f) throws Exception {
        java.security.MessageDigest md = java.security.MessageDigest.getInstance("SHA-256");
        try (InputStream in = Files.newInputStream(f)) {
            byte[] buf = new byte[1 << 16];
            for (int n; (n = in.read(buf)) > 0; ) md.update(buf, 0, n);
        }
        return String.format("%064x", new java.math.BigInteger(1, md.digest()));
    }

    static void delete(Path dir) throws IOException {
        if (!Files.exists(dir)) return;
        try (java.util.stream.Stream<Path> s = Files.walk(dir)) {
            for (Path p : (Iterable<Path>) s.sorted(Comparator.reverseOrder())::iterator)
                Files.delete(p);
        }
    }

    static Map<String, byte[]> compile(String pkg, String name, String source) throws IOException {
        Path dir = Files.createTempDirectory("assemble"),
                src = Files.writeString(dir.resolve(name + ".java"), source);
        if (javax.tools.ToolProvider.getSystemJavaCompiler()
                        .run(
                                null,
                                null,
                                null,
                                "--release",
                                "8",
                                "-Xlint:-options",
                                "-d",
                                dir.toString(),
                                src.toString())
                != 0) throw new IOException("javac");
        String path = pkg.replace('.', '/') + "/" + name + ".class";
        return Map.of(path, Files.readAllBytes(dir.resolve(path)));
    }

    static Path find(Path dir, String prefix) throws IOException {
        try (DirectoryStream<Path> ds = Files.newDirectoryStream(dir, prefix + "*.jar")) {
            return ds.iterator().next();
        }
    }

    static boolean drop(String n) {
        return n.startsWith(P + "META-INF/")
                || n.startsWith("META-INF/maven/")
                || n.startsWith("META-INF/versions/")
                || n.endsWith("module-info.class")
                || n.startsWith(P + "org/jetbrains/kotlin/")
                || n.startsWith("groovy/")
                || n.startsWith("org/codehaus/groovy/")
                || n.startsWith("org/apache/groovy/")
                || n.equals("META-INF/MANIFEST.MF")
                || n.matches("META-INF/([^/]+\\.(SF|RSA|DSA|EC)|INDEX\\.LIST)");
    }

    /**
     * Ant and the test frameworks are loaded apart from, or must never shadow, what a build brings
     * along.
     */
    static final String[][] ROUTES = {
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

    static String route(String n) {
        for (String[] r : ROUTES) if (n.startsWith(r[0])) return r[1];
        return null;
    }

    static boolean thirdParty(String n) {
        if (n.startsWith("org/gradle/") || n.startsWith("org/slf4j/impl/")) return false;
        int i = n.indexOf('/');
        if (i < 0)
            return !(n.startsWith("gradle-")
                    || n.endsWith("default-imports.txt")
                    || n.endsWith("api-mapping.txt")
                    || n.equals("release-features.txt")
                    || n.equals("instrumented-super-types.properties")
                    || n.equals("upgraded-properties.json"));
        return !n.startsWith("META-INF/gradle-plugins/");
    }

    static String strip(String s) {
        int i = s.indexOf(P);
        if (i >= 0 && s.length() > i + P.length()) s = s.replace(P, "");
        i = s.indexOf(D);
        if (i >= 0 && s.length() > i + D.length()) s = s.replace(D, "");
        return s;
    }

    /** rewrites CONSTANT_Utf8 entries, nothing else in a class file depends on their length */
    static byte[] unshade(byte[] b) throws IOException {
        DataInputStream in = new DataInputStream(new ByteArrayInputStream(b));
        ByteArrayOutputStream bo = new ByteArrayOutputStream(b.length);
        DataOutputStream o = new DataOutputStream(bo);
        o.writeInt(in.readInt());
        o.writeShort(in.readUnsignedShort());
        o.writeShort(in.readUnsignedShort());
        int n = in.readUnsignedShort();
        o.writeShort(n);
        for (int i = 1; i < n; i++) {
            int tag = in.readUnsignedByte();
            o.writeByte(tag);
            switch (tag) {
                case 1:
                    o.writeUTF(strip(in.readUTF()));
                    break;
                case 3:
                case 4:
                case 9:
                case 10:
                case 11:
                case 12:
                case 17:
                case 18:
                    o.writeInt(in.readInt());
                    break;
                case 5:
                case 6:
                    o.writeLong(in.readLong());
                    i++;
                    break;
                case 7:
                case 8:
                case 16:
                case 19:
                case 20:
                    o.writeShort(in.readUnsignedShort());
                    break;
                case 15:
                    o.writeByte(in.readUnsignedByte());
                    o.writeShort(in.readUnsignedShort());
                    break;
                default:
                    throw new IOException("constant tag " + tag);
            }
        }
        in.transferTo(o);
        return bo.toByteArray();
    }

    static byte[] emptyClass(String name) throws IOException {
        ByteArrayOutputStream b = new ByteArrayOutputStream();
        DataOutputStream o = new DataOutputStream(b);
        o.writeInt(0xCAFEBABE);
        o.writeInt(52);
        o.writeShort(5);
        o.writeByte(7);
        o.writeShort(2);
        o.writeByte(1);
        o.writeUTF(name);
        o.writeByte(7);
        o.writeShort(4);
        o.writeByte(1);
        o.writeUTF("java/lang/Object");
        o.writeShort(0x21);
        o.writeShort(1);
        o.writeShort(3);
        for (int i = 0; i < 4; i++) o.writeShort(0);
        return b.toByteArray();
    }

    static byte[] cat(byte[] x, byte[] y) {
        byte[] r = Arrays.copyOf(x, x.length + y.length);
        System.arraycopy(y, 0, r, x.length, y.length);
        return r;
    }

    static Properties props(Out o) throws IOException {
        Properties p = new Properties();
        byte[] b = o.entries.get(o.name + SFX);
        if (b != null) p.load(new ByteArrayInputStream(b));
        return p;
    }

    static void write(Path f, Map<String, byte[]> es, String classPath) throws IOException {
        try (ZipOutputStream z =
                new ZipOutputStream(new BufferedOutputStream(Files.newOutputStream(f)))) {
            z.setLevel(1);
            StringBuilder mf = new StringBuilder("Manifest-Version: 1.0\r\n");
            if (classPath != null) {
                String l = "Class-Path: " + classPath;
                while (l.length() > 70) {
                    mf.append(l, 0, 70).append("\r\n");
                    l = " " + l.substring(70);
                }
                mf.append(l).append("\r\n");
            }
            put(z, "META-INF/MANIFEST.MF", mf.append("\r\n").toString().getBytes());
            for (Map.Entry<String, byte[]> e : es.entrySet()) put(z, e.getKey(), e.getValue());
        }
    }

    static void put(ZipOutputStream z, String n, byte[] b) throws IOException {
        ZipEntry e = new ZipEntry(n);
        e.setTime(315532800000L);
        z.putNextEntry(e);
        z.write(b);
        z.closeEntry();
    }
}
