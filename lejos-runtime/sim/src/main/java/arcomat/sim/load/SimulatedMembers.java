package arcomat.sim.load;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;

import java.io.IOException;
import java.io.InputStream;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What a program can name on a simulated brick: those members of leJOS that are simulated, and of
 * the PC's own Java what does not reach the PC. Names are those of class files.
 */
public final class SimulatedMembers {
    /** Types of the brick's Java that would be the PC's files, network and clock. */
    private static final Set<String> OF_THE_PC =
            Set.of(
                    "java/io/File",
                    "java/io/FileInputStream",
                    "java/io/FileOutputStream",
                    "java/net/ServerSocket",
                    "java/net/Socket",
                    "java/util/Timer");

    /** Members that would look into this process, or leave something behind in it. */
    private static final Set<String> OF_THIS_PROCESS =
            Set.of(
                    "java/lang/Class.forName",
                    "java/lang/Runtime.addShutdownHook",
                    "java/lang/Runtime.removeShutdownHook",
                    "java/lang/Runtime.freeMemory",
                    "java/lang/Runtime.totalMemory",
                    "java/lang/System.getProperty",
                    "java/lang/Thread.getDefaultUncaughtExceptionHandler",
                    "java/lang/Thread.setDefaultUncaughtExceptionHandler",
                    "java/lang/Thread.getUncaughtExceptionHandler",
                    "java/lang/Thread.setUncaughtExceptionHandler");

    private final Map<String, Optional<ClassNode>> types = new HashMap<>();

    /** Whether a class that is not the program's own can be used. */
    public boolean has(String type) {
        return !OF_THE_PC.contains(type) && type(type).isPresent();
    }

    /** Whether a class has a member or inherits it. */
    public boolean has(String owner, String name, String descriptor) {
        if (!has(owner) || OF_THIS_PROCESS.contains(owner + "." + name)) {
            return false;
        }
        ClassNode node = type(owner).orElseThrow();
        return declares(node, name, descriptor)
                || node.superName != null && has(node.superName, name, descriptor)
                || node.interfaces.stream().anyMatch(each -> has(each, name, descriptor));
    }

    private static boolean declares(ClassNode node, String name, String descriptor) {
        return node.methods.stream()
                        .filter(method -> isOpen(method.access))
                        .anyMatch(m -> m.name.equals(name) && m.desc.equals(descriptor))
                || node.fields.stream()
                        .filter(field -> isOpen(field.access))
                        .anyMatch(f -> f.name.equals(name) && f.desc.equals(descriptor));
    }

    private static boolean isOpen(int access) {
        return (access & (Opcodes.ACC_PUBLIC | Opcodes.ACC_PROTECTED)) != 0;
    }

    private Optional<ClassNode> type(String name) {
        return types.computeIfAbsent(name, SimulatedMembers::read);
    }

    /** Nothing but Java and leJOS: the simulation's own classes are not for programs. */
    private static Optional<ClassNode> read(String name) {
        if (!name.startsWith("java/") && !BrickLoader.isOfTheBrick(name.replace('/', '.'))) {
            return Optional.empty();
        }
        String path = name + ".class";
        ClassLoader loader = SimulatedMembers.class.getClassLoader();
        try (InputStream stream = loader.getResourceAsStream(path)) {
            if (stream == null) {
                return Optional.empty();
            }
            ClassNode node = new ClassNode();
            new ClassReader(stream)
                    .accept(
                            node,
                            ClassReader.SKIP_CODE
                                    | ClassReader.SKIP_DEBUG
                                    | ClassReader.SKIP_FRAMES);
            return Optional.of(node);
        } catch (IOException e) {
            throw new IllegalStateException("cannot read " + path, e);
        }
    }
}
