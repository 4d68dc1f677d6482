package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Whatever a program can name of the simulated brick, the real one has: every public or protected
 * member of the simulated classes is a line of the table, with the same access, types, constant and
 * exceptions.
 */
class MemberTableTest {
    private static final Path TABLE = Path.of("../api/lejos-nxj-0.9.1.tsv");
    private static final Path LACKING = Path.of("src/test/resources/lacking.txt");
    private static final Pattern MAIN_PACKAGE = Pattern.compile("lejos/nxt/[^/]+");
    private static final Pattern MEMBER = Pattern.compile("(?:field|method) (\\S+) .*?(\\S+) \\S+");
    private static final String IMPLEMENTS = "implements ";
    private static final int OWNER = IMPLEMENTS.length();
    private static final int SEEN = Opcodes.ACC_PUBLIC | Opcodes.ACC_PROTECTED;

    @TestFactory
    Stream<DynamicTest> everyMemberIsInTheTable() throws IOException, URISyntaxException {
        Map<String, Set<String>> table = table();
        List<DynamicTest> tests = new ArrayList<>();
        for (Path file : classFiles()) {
            Lines lines = new Lines();
            new ClassReader(Files.readAllBytes(file)).accept(lines, ClassReader.SKIP_CODE);
            if (lines.isPublic) {
                tests.add(
                        DynamicTest.dynamicTest(
                                lines.name,
                                () ->
                                        assertThat(table.getOrDefault(lines.name, Set.of()))
                                                .containsAll(lines.lines)));
            }
        }
        assertThat(tests).hasSizeGreaterThan(40);
        return tests.stream();
    }

    /**
     * What {@code run-brick} refuses in the brick's main package is as listed, class by class: a
     * program that needs more is told so, and a member that gets lost here is noticed.
     */
    @Test
    void whatIsLackingIsListed() throws IOException, URISyntaxException {
        Set<String> simulated = new HashSet<>();
        for (Path file : classFiles()) {
            Lines lines = new Lines();
            new ClassReader(Files.readAllBytes(file)).accept(lines, ClassReader.SKIP_CODE);
            lines.lines.forEach(line -> simulated.add(lines.name + " " + key(line)));
        }
        List<String> lacking = new ArrayList<>();
        table().forEach(
                        (type, members) -> {
                            if (MAIN_PACKAGE.matcher(type).matches()) {
                                lacking.addAll(lacking(type, members, simulated));
                            }
                        });
        assertThat(lacking.stream().sorted()).containsExactlyElementsOf(listed());
    }

    /** A simulated class is also whatever it is on the brick, as far as that is simulated. */
    @Test
    void interfacesAreThoseOfTheBrick() throws IOException, URISyntaxException {
        Map<String, List<String>> simulated = new HashMap<>();
        for (Path file : classFiles()) {
            Lines lines = new Lines();
            new ClassReader(Files.readAllBytes(file)).accept(lines, ClassReader.SKIP_CODE);
            simulated.put(lines.name, lines.lines);
        }
        Map<String, Set<String>> table = table();
        List<String> lost = new ArrayList<>();
        simulated.forEach(
                (type, lines) ->
                        table.getOrDefault(type, Set.of()).stream()
                                .filter(line -> line.startsWith(IMPLEMENTS))
                                .filter(line -> simulated.containsKey(line.substring(OWNER)))
                                .filter(line -> !lines.contains(line))
                                .forEach(line -> lost.add(type + " " + line)));
        assertThat(lost).isEmpty();
    }

    private static List<String> lacking(String type, Set<String> members, Set<String> simulated) {
        List<String> own =
                members.stream()
                        .filter(MemberTableTest::isMember)
                        .map(MemberTableTest::key)
                        .toList();
        List<String> missing =
                own.stream().filter(member -> !simulated.contains(type + " " + member)).toList();
        String name = type.substring(type.lastIndexOf('/') + 1);
        if (!own.isEmpty() && missing.size() == own.size()) {
            return List.of(name + " all " + own.size());
        }
        return missing.stream().map(member -> name + " " + member).toList();
    }

    private static boolean isMember(String line) {
        return line.startsWith("field ") || line.startsWith("method ");
    }

    /** Name and types of a member. */
    private static String key(String line) {
        Matcher matcher = MEMBER.matcher(line);
        return matcher.matches() ? matcher.group(1) + " " + matcher.group(2) : line;
    }

    private static List<String> listed() throws IOException {
        return Files.readAllLines(LACKING).stream().filter(line -> !line.startsWith("#")).toList();
    }

    private static List<Path> classFiles() throws IOException, URISyntaxException {
        Path root =
                Path.of(
                        Laboratory.class
                                .getProtectionDomain()
                                .getCodeSource()
                                .getLocation()
                                .toURI());
        List<Path> files = new ArrayList<>();
        for (String folder : List.of("lejos", "javax")) {
            try (Stream<Path> walk = Files.walk(root.resolve(folder))) {
                walk.filter(path -> path.toString().endsWith(".class")).forEach(files::add);
            }
        }
        files.removeIf(path -> path.endsWith("package-info.class"));
        return files;
    }

    private static Map<String, Set<String>> table() throws IOException {
        Map<String, Set<String>> table = new HashMap<>();
        Set<String> members = Set.of();
        for (String line : Files.readAllLines(TABLE)) {
            String[] columns = line.split("\t");
            if (columns[0].equals("class")) {
                members = table.computeIfAbsent(columns[1], name -> new HashSet<>());
            }
            members.add(withoutSignature(columns));
            if (columns[0].equals("class")) {
                members.addAll(interfaces(columns[4].split(",")));
            }
        }
        return table;
    }

    /** The same erased types are enough: simulated members are no more generic than the brick's. */
    private static String withoutSignature(String[] columns) {
        return switch (columns[0]) {
            case "class" -> "class " + columns[1] + " " + columns[2] + " " + columns[3];
            case "method" ->
                    "method " + columns[1] + " " + columns[2] + " " + columns[3] + " " + columns[5];
            case "field" ->
                    "field " + columns[1] + " " + columns[2] + " " + columns[3] + " " + columns[5];
            default -> "";
        };
    }

    private static List<String> interfaces(String[] names) {
        return Arrays.stream(names).map(name -> IMPLEMENTS + name).toList();
    }

    private static final class Lines extends ClassVisitor {
        private final List<String> lines = new ArrayList<>();
        private String name;
        private boolean isPublic;

        Lines() {
            super(Opcodes.ASM9);
        }

        @Override
        public void visit(
                int version,
                int access,
                String className,
                String signature,
                String superName,
                String[] interfaces) {
            name = className;
            isPublic = (access & Opcodes.ACC_PUBLIC) != 0;
            lines.add("class %s %s %s".formatted(className, words(access), superName));
            lines.addAll(interfaces(interfaces));
        }

        @Override
        public FieldVisitor visitField(
                int access, String field, String descriptor, String signature, Object value) {
            if ((access & SEEN) != 0) {
                String constant = value == null ? "-" : value.toString();
                lines.add(
                        "field %s %s %s %s".formatted(field, words(access), descriptor, constant));
            }
            return null;
        }

        @Override
        public MethodVisitor visitMethod(
                int access, String method, String descriptor, String signature, String[] thrown) {
            boolean synthetic = (access & Opcodes.ACC_SYNTHETIC) != 0;
            if ((access & SEEN) != 0 && !synthetic) {
                lines.add(
                        "method %s %s %s %s"
                                .formatted(method, words(access), descriptor, list(thrown)));
            }
            return null;
        }

        private static String list(String[] names) {
            return names == null || names.length == 0 ? "-" : String.join(",", names);
        }

        /** In the table's order. */
        private static String words(int access) {
            List<String> words = new ArrayList<>();
            if ((access & Opcodes.ACC_PUBLIC) != 0) {
                words.add("public");
            }
            if ((access & Opcodes.ACC_PROTECTED) != 0) {
                words.add("protected");
            }
            if ((access & Opcodes.ACC_STATIC) != 0) {
                words.add("static");
            }
            if ((access & Opcodes.ACC_FINAL) != 0) {
                words.add("final");
            }
            if ((access & Opcodes.ACC_INTERFACE) != 0) {
                words.add("interface");
            }
            if ((access & Opcodes.ACC_ABSTRACT) != 0) {
                words.add("abstract");
            }
            return String.join(" ", words);
        }
    }
}
