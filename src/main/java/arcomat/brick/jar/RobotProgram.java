package arcomat.brick.jar;

import arcomat.brick.api.BrickTable;
import arcomat.brick.jar.ReferenceSearch.Reference;
import arcomat.brick.need.Needs;
import arcomat.source.SourceFile;
import arcomat.source.Span;

import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Stream;

/** A robot's classes as they were read, together with what the brick offers to them. */
public final class RobotProgram {
    private final RobotJar jar;
    private final BrickTable table;
    private final List<ClassFile> files;
    private final Map<String, ClassNode> own = new HashMap<>();
    private final List<Reference> references;
    private final Needs needs;

    private RobotProgram(RobotJar jar, BrickTable table, List<ClassFile> files) {
        this.jar = jar;
        this.table = table;
        this.files = List.copyOf(files);
        files.forEach(file -> file.node().ifPresent(node -> own.put(node.name, node)));
        this.references = inClasses((f, node) -> ReferenceSearch.of(f, node).stream()).toList();
        this.needs = Needs.of(own.values(), table);
    }

    public static RobotProgram read(RobotJar jar, BrickTable table) {
        List<ClassFile> files =
                jar.classes().stream().map(given -> ClassFile.read(given, jar.path())).toList();
        return new RobotProgram(jar, table, files);
    }

    /** All class files, those that cannot be read included. */
    public List<ClassFile> files() {
        return files;
    }

    public BrickTable table() {
        return table;
    }

    /** The robot's own class of an internal name. */
    public Optional<ClassNode> own(String name) {
        return Optional.ofNullable(own.get(name));
    }

    /** All places where the robot's classes name types and members. */
    public List<Reference> references() {
        return references;
    }

    /** What it needs of the brick. */
    public Needs needs() {
        return needs;
    }

    /** The place of findings about the program as a whole. */
    public Span span() {
        return new SourceFile(jar.path(), "").span(0, 0);
    }

    /** What is found at an instruction of a method. */
    public interface PerInstruction<I, T> {
        Stream<T> of(ClassFile file, MethodNode method, I instruction);
    }

    /** Applies a function to each instruction of a kind, in the order of the class files. */
    public <I extends AbstractInsnNode, T> Stream<T> inInstructions(
            Class<I> kind, PerInstruction<I, T> function) {
        return inClasses(
                (file, node) ->
                        node.methods.stream().flatMap(m -> inMethod(file, m, kind, function)));
    }

    private static <I extends AbstractInsnNode, T> Stream<T> inMethod(
            ClassFile file, MethodNode method, Class<I> kind, PerInstruction<I, T> function) {
        return Arrays.stream(method.instructions.toArray())
                .filter(kind::isInstance)
                .flatMap(each -> function.of(file, method, kind.cast(each)));
    }

    /** Applies a function to each class that could be read. */
    public <T> Stream<T> inClasses(BiFunction<ClassFile, ClassNode, Stream<T>> function) {
        return files.stream()
                .flatMap(file -> file.node().stream().flatMap(node -> function.apply(file, node)));
    }
}
