package arcomat.brick;

import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.ClassNode;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeSet;

/**
 * What a program needs of the classes that there are: its main class, and whatever a needed class
 * names. Room on the brick is scarce, so nothing else goes into a robot's jar.
 */
public final class ReachableClasses {
    private static final int CLASS_CONSTANT = 7;
    private static final int SIGNATURE_CONSTANT = 12;

    private ReachableClasses() {}

    /**
     * @param main internal name of the main class
     * @param classes class files by internal name
     * @return internal names
     */
    public static SortedSet<String> from(String main, Map<String, byte[]> classes) {
        SortedSet<String> reached = new TreeSet<>();
        Deque<String> open = new ArrayDeque<>(Set.of(main));
        while (!open.isEmpty()) {
            String name = open.pop();
            if (classes.containsKey(name) && reached.add(name)) {
                open.addAll(namedIn(classes.get(name)));
            }
        }
        return reached;
    }

    /** The classes that a class file names, in its code or in the types of its members. */
    private static Set<String> namedIn(byte[] file) {
        ClassReader reader = new ClassReader(file);
        Set<String> names = new HashSet<>();
        addConstants(reader, names);
        ClassNode node = new ClassNode();
        reader.accept(node, ClassReader.SKIP_CODE);
        node.fields.forEach(field -> add(Type.getType(field.desc), names));
        node.methods.forEach(method -> add(Type.getType(method.desc), names));
        return names;
    }

    private static void addConstants(ClassReader reader, Set<String> names) {
        char[] buffer = new char[reader.getMaxStringLength()];
        for (int item = 1; item < reader.getItemCount(); item++) {
            int offset = reader.getItem(item);
            if (offset == 0) {
                continue; // the second half of a long or a double
            }
            int tag = reader.readByte(offset - 1);
            if (tag == CLASS_CONSTANT) {
                add(Type.getObjectType(reader.readUTF8(offset, buffer)), names);
            } else if (tag == SIGNATURE_CONSTANT) {
                add(Type.getType(reader.readUTF8(offset + 2, buffer)), names);
            }
        }
    }

    private static void add(Type type, Set<String> names) {
        if (type.getSort() == Type.ARRAY) {
            add(type.getElementType(), names);
        } else if (type.getSort() == Type.OBJECT) {
            names.add(type.getInternalName());
        } else if (type.getSort() == Type.METHOD) {
            add(type.getReturnType(), names);
            for (Type argument : type.getArgumentTypes()) {
                add(argument, names);
            }
        }
    }
}
