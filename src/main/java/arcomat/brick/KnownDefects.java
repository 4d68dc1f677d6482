package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** ARC0914: some methods are there on leJOS NXJ 0.9.1 and do not do what they should (measured). */
final class KnownDefects implements BrickLaw {
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

    @Override
    public String code() {
        return "ARC0914";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inInstructions(
                MethodInsnNode.class,
                (file, method, call) ->
                        defect(program, call)
                                .filter(text -> !isGeneratedByCompiler(file, method))
                                .map(text -> finding(file, method, call, text))
                                .stream());
    }

    /** Every enum has a valueOf that nobody need call. */
    private static boolean isGeneratedByCompiler(ClassFile file, MethodNode method) {
        return method.name.equals("valueOf")
                && file.node().filter(node -> (node.access & Opcodes.ACC_ENUM) != 0).isPresent();
    }

    private Diagnostic finding(
            ClassFile file, MethodNode method, AbstractInsnNode each, String defect) {
        return Diagnostic.warning(
                code(), file.span(method, each), file.where(method, each) + " " + defect);
    }

    private static Optional<String> defect(Program program, MethodInsnNode call) {
        if (call.owner.equals("java/lang/String") && call.name.equals("compareTo")) {
            return Optional.of(
                    "calls String.compareTo, which on the brick takes texts of equal length for"
                            + " equal; compare their characters, or use equals");
        }
        if (call.name.equals("valueOf") && isEnum(program, call.owner)) {
            return Optional.of(
                    "calls "
                            + Names.simple(call.owner)
                            + ".valueOf, which always throws on the brick; compare the text with"
                            + " the name() of each constant");
        }
        if (HASHED.contains(call.owner) && HASHING.contains(call.name)) {
            return Optional.of(
                    "uses "
                            + Names.simple(call.owner)
                            + ", which on the brick throws for a key with a negative hashCode; use"
                            + " java.util.Hashtable, or search a list");
        }
        return Optional.empty();
    }

    private static boolean isEnum(Program program, String owner) {
        return owner.equals("java/lang/Enum")
                || program.own(owner).filter(n -> (n.access & Opcodes.ACC_ENUM) != 0).isPresent()
                || program.table().type(owner).filter(t -> t.isEnum()).isPresent();
    }
}
