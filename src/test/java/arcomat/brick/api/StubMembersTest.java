package arcomat.brick.api;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** The stubs, read back, are the table: every class with every member, and nothing more. */
class StubMembersTest {
    private static final BrickTable TABLE = BrickTable.leJos();

    @Test
    void everyLineOfTheTableIsRead() throws IOException {
        Map<String, Long> lines =
                tableText()
                        .lines()
                        .collect(
                                Collectors.groupingBy(
                                        line -> line.split("\t")[0], Collectors.counting()));

        assertThat(TABLE.types()).hasSize(lines.get("class").intValue());
        assertThat(TABLE.types().stream().flatMap(t -> t.fields().stream()))
                .hasSize(lines.get("field").intValue());
        assertThat(TABLE.types().stream().flatMap(t -> t.methods().stream()))
                .hasSize(lines.get("method").intValue());
        assertThat(TABLE.types().stream().filter(t -> t.nesting().isPresent()))
                .hasSize(lines.get("inner").intValue());
    }

    @TestFactory
    Stream<DynamicTest> aStubReadBackIsItsLinesOfTheTable() {
        Map<String, List<BrickType>> packages =
                TABLE.types().stream().collect(Collectors.groupingBy(BrickType::packageName));
        return packages.entrySet().stream()
                .sorted(Map.Entry.comparingByKey())
                .map(
                        entry ->
                                DynamicTest.dynamicTest(
                                        entry.getKey(),
                                        () -> entry.getValue().forEach(this::compare)));
    }

    private void compare(BrickType type) {
        Lines lines = new Lines();
        new ClassReader(new StubWriter(TABLE).write(type)).accept(lines, 0);

        List<String> expected = new ArrayList<>();
        expected.add(
                line(
                        type.access(),
                        type.name(),
                        type.superclass(),
                        type.interfaces(),
                        type.signature()));
        type.nesting().ifPresent(n -> expected.add(line(n.access(), n.outer(), n.simpleName())));
        type.fields()
                .forEach(
                        f ->
                                expected.add(
                                        line(
                                                f.access(),
                                                f.name(),
                                                f.descriptor(),
                                                f.signature(),
                                                f.constant())));
        type.methods()
                .forEach(
                        m ->
                                expected.add(
                                        line(
                                                m.access(),
                                                m.name(),
                                                m.descriptor(),
                                                m.signature(),
                                                m.exceptions())));
        assertThat(lines.text).containsExactlyInAnyOrderElementsOf(expected);
    }

    @Test
    void aNestedClassNamesAllClassesAroundIt() {
        List<String> names = new ArrayList<>();
        BrickType innermost =
                TABLE.type("java/util/HashMap$LinkedListForEntries$LinkedListIterator").get();
        new ClassReader(new StubWriter(TABLE).write(innermost))
                .accept(
                        new ClassVisitor(Opcodes.ASM9) {
                            @Override
                            public void visitInnerClass(
                                    String name, String outer, String simpleName, int access) {
                                names.add(simpleName);
                            }
                        },
                        0);

        assertThat(names).containsExactly("LinkedListForEntries", "LinkedListIterator");
    }

    @Test
    void packagesAreThoseWithClassesAndThoseAround() {
        assertThat(TABLE.isPackage("lejos/nxt")).isTrue();
        assertThat(TABLE.isPackage("javax")).isTrue();
        assertThat(TABLE.isPackage("lejos/nxt/Motor")).isFalse();
        assertThat(TABLE.isPackage("java/text")).isFalse();
    }

    @Test
    void aBrokenLineIsNamedByItsNumber() {
        assertThatThrownBy(() -> TableReader.read("class\tA\tpublic\tnull\t-\t-\nfield\tx\tloud"))
                .hasMessage("line 2: unknown access flag loud");
        assertThatThrownBy(() -> TableReader.read("thing\tA"))
                .hasMessage("line 1: unknown kind thing");
    }

    private static String tableText() throws IOException {
        try (InputStream in = BrickTable.class.getResourceAsStream("lejos-nxj-0.9.1.tsv")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static String line(Object... words) {
        return Stream.of(words).map(StubMembersTest::word).collect(Collectors.joining(" "));
    }

    private static String word(Object word) {
        return word instanceof java.util.Optional<?> optional
                ? optional.map(Object::toString).orElse("-")
                : String.valueOf(word);
    }

    /** A class file as lines of the same form as those of the table's records. */
    private static final class Lines extends ClassVisitor {
        final List<String> text = new ArrayList<>();
        private String name;

        Lines() {
            super(Opcodes.ASM9);
        }

        @Override
        public void visit(
                int version,
                int access,
                String name,
                String signature,
                String superName,
                String[] interfaces) {
            this.name = name;
            text.add(
                    line(
                            access & ~Opcodes.ACC_SUPER,
                            name,
                            optional(superName),
                            List.of(interfaces),
                            optional(signature)));
        }

        @Override
        public void visitInnerClass(String inner, String outer, String simpleName, int access) {
            if (inner.equals(name)) {
                text.add(line(access, outer, simpleName));
            }
        }

        @Override
        public FieldVisitor visitField(
                int access, String field, String descriptor, String signature, Object value) {
            text.add(line(access, field, descriptor, optional(signature), optional(value)));
            return null;
        }

        @Override
        public MethodVisitor visitMethod(
                int access,
                String method,
                String descriptor,
                String signature,
                String[] exceptions) {
            List<String> thrown = exceptions == null ? List.of() : List.of(exceptions);
            text.add(line(access, method, descriptor, optional(signature), thrown));
            return null;
        }

        private static Object optional(Object value) {
            return java.util.Optional.ofNullable(value);
        }
    }
}
