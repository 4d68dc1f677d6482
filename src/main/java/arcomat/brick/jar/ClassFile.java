package arcomat.brick.jar;

import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.LineNumberNode;
import org.objectweb.asm.tree.MethodNode;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A class of the jar, read as far as it can be, and the places of findings about it. */
public final class ClassFile {
    private static final int MAGIC = 0xCAFEBABE;
    private static final int VERSION_OFFSET = 6;

    private final RobotClass given;
    private final SourceFile file;
    private final Optional<ClassNode> node;

    private ClassFile(RobotClass given, SourceFile file, Optional<ClassNode> node) {
        this.given = given;
        this.file = file;
        this.node = node;
    }

    static ClassFile read(RobotClass given, String jar) {
        SourceFile file =
                given.text().orElseGet(() -> new SourceFile(jar + "!/" + given.path(), ""));
        return new ClassFile(given, file, node(given.bytes()));
    }

    /** Nothing if the bytes are no class file, or one of a form that is still unknown here. */
    private static Optional<ClassNode> node(byte[] bytes) {
        try {
            ClassNode node = new ClassNode();
            new ClassReader(bytes).accept(node, ClassReader.SKIP_FRAMES);
            return Optional.of(node).filter(Descriptors::areWellFormed);
        } catch (RuntimeException e) { // what ClassReader throws on damaged files is not specified
            return Optional.empty();
        }
    }

    public Optional<ClassNode> node() {
        return node;
    }

    public Origin origin() {
        return given.origin();
    }

    public int size() {
        return given.bytes().length;
    }

    public int methods() {
        return node.map(n -> n.methods.size()).orElse(0);
    }

    /** Name as in Java; of a file that cannot be read, its path in the jar. */
    public String name() {
        return node.map(n -> JavaNames.type(n.name)).orElse(given.path());
    }

    /** Major version of the class file, if it starts as one. */
    public Optional<Integer> version() {
        ByteBuffer bytes = ByteBuffer.wrap(given.bytes());
        boolean isClassFile = bytes.limit() > VERSION_OFFSET + 1 && bytes.getInt(0) == MAGIC;
        return isClassFile
                ? Optional.of(Short.toUnsignedInt(bytes.getShort(VERSION_OFFSET)))
                : Optional.empty();
    }

    /** Where the class is declared. */
    public Span span() {
        String simple = name().replaceFirst(".*[.$]", "");
        Matcher declared =
                Pattern.compile("\\b(?:class|interface|enum) (" + Pattern.quote(simple) + ")\\b")
                        .matcher(file.text());
        return declared.find() ? file.span(declared.start(1), declared.end(1)) : file.span(0, 0);
    }

    /** The first line of a method's body; the class if it has none. */
    public Span span(MethodNode method) {
        for (AbstractInsnNode each : method.instructions) {
            if (each instanceof LineNumberNode line) {
                return line(line.line);
            }
        }
        return span();
    }

    /** The line of an instruction. */
    public Span span(MethodNode method, AbstractInsnNode instruction) {
        return lineNumber(instruction).map(this::line).orElseGet(() -> span(method));
    }

    /**
     * Says where an instruction is: {@code robot.Main.run}, with its line where no text shows it.
     */
    public String where(MethodNode method, AbstractInsnNode instruction) {
        return given.text().isPresent()
                ? where(method)
                : where(method)
                        + lineNumber(instruction).map(line -> " (line " + line + ")").orElse("");
    }

    /** Names a method for people. */
    public String where(MethodNode method) {
        return switch (method.name) {
            case "<init>" -> "the constructor of " + name();
            case "<clinit>" -> "the static part of " + name();
            default -> name() + "." + method.name;
        };
    }

    private static Optional<Integer> lineNumber(AbstractInsnNode instruction) {
        AbstractInsnNode each = instruction;
        // The line of a label, where a handler starts, stands behind it.
        while (each.getOpcode() < 0
                && !(each instanceof LineNumberNode)
                && each.getNext() != null) {
            each = each.getNext();
        }
        while (each != null && !(each instanceof LineNumberNode)) {
            each = each.getPrevious();
        }
        return each instanceof LineNumberNode line ? Optional.of(line.line) : Optional.empty();
    }

    /** A line without its indentation; the whole file's start where the text does not have it. */
    private Span line(int number) {
        if (number < 1 || number > file.lineCount()) {
            return file.span(0, 0);
        }
        String text = file.line(number);
        int indent = text.length() - text.stripLeading().length();
        int start = file.lineStart(number);
        return file.span(start + indent, start + Math.max(indent, text.stripTrailing().length()));
    }
}
