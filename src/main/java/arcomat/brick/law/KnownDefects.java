package arcomat.brick.law;

import arcomat.brick.jar.ClassFile;
import arcomat.brick.jar.JavaNames;
import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** ARC0914: some methods are there on leJOS NXJ 0.9.1 and do not do what they should (measured). */
final class KnownDefects extends BrickLaw {
    /** Collections that take the remainder of a hash code for an index, negative or not. */
    private static final List<String> HASHED = List.of("java/util/HashMap", "java/util/HashSet");

    /** Whoever has made one, or inherits from one, calls this. */
    private static final String CONSTRUCTOR = "<init>";

    private static final Set<String> HASHING =
            Set.of(
                    CONSTRUCTOR,
                    "add",
                    "addAll",
                    "contains",
                    "containsAll",
                    "containsKey",
                    "get",
                    "put",
                    "putAll",
                    "remove",
                    "removeAll");

    KnownDefects() {
        super("ARC0914");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inInstructions(
                MethodInsnNode.class,
                (file, method, call) ->
                        defect(program, call)
                                .filter(text -> !isGeneratedByCompiler(file, method))
                                .map(
                                        text ->
                                                warning(
                                                        file.span(method, call),
                                                        "%s %s",
                                                        file.where(method, call),
                                                        text))
                                .stream());
    }

    /** Every enum has a valueOf that nobody need call. */
    private static boolean isGeneratedByCompiler(ClassFile file, MethodNode method) {
        return method.name.equals("valueOf")
                && file.node().filter(node -> (node.access & Opcodes.ACC_ENUM) != 0).isPresent();
    }

    private static Optional<String> defect(RobotProgram program, MethodInsnNode call) {
        if (call.owner.equals("java/lang/String") && call.name.equals("compareTo")) {
            return Optional.of(
                    "calls String.compareTo, which on the brick takes texts of equal length for"
                            + " equal; compare their characters, or use equals");
        }
        if (call.name.equals("valueOf") && isEnum(program, call.owner)) {
            return Optional.of(
                    "calls %s.valueOf, which always throws on the brick; compare the text with the name() of each constant"
                            .formatted(JavaNames.simple(call.owner)));
        }
        if (HASHED.contains(call.owner) && HASHING.contains(call.name)) {
            return Optional.of(
                    "uses %s, which on the brick throws for a key with a negative hashCode; use java.util.Hashtable, or search a list"
                            .formatted(JavaNames.simple(call.owner)));
        }
        return Optional.empty();
    }

    private static boolean isEnum(RobotProgram program, String owner) {
        return owner.equals("java/lang/Enum")
                || program.own(owner).filter(n -> (n.access & Opcodes.ACC_ENUM) != 0).isPresent()
                || program.table().type(owner).filter(t -> t.isEnum()).isPresent();
    }
}
