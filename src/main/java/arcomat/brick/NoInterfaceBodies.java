package arcomat.brick;

import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/** ARC0903: default methods fail when the brick calls them, static ones crash its machine. */
final class NoInterfaceBodies implements BrickLaw {
    private static final String CONSTANTS = "<clinit>";

    @Override
    public String code() {
        return "ARC0903";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inClasses(
                (file, node) ->
                        isInterface(node)
                                ? node.methods.stream()
                                        .filter(NoInterfaceBodies::hasBody)
                                        .map(method -> finding(file, method))
                                : Stream.empty());
    }

    private static boolean isInterface(ClassNode node) {
        return (node.access & Opcodes.ACC_INTERFACE) != 0;
    }

    private static boolean hasBody(MethodNode method) {
        return (method.access & Opcodes.ACC_ABSTRACT) == 0 && !method.name.equals(CONSTANTS);
    }

    private Diagnostic finding(ClassFile file, MethodNode method) {
        String kind = (method.access & Opcodes.ACC_STATIC) != 0 ? "static" : "default";
        return Diagnostic.error(
                code(),
                file.span(method),
                "interface "
                        + file.name()
                        + " has the "
                        + kind
                        + " method "
                        + method.name
                        + ", which fails on the brick; move the body to a class");
    }
}
