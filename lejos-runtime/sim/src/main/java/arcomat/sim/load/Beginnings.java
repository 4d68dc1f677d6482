package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * When classes of a brick begin, that is, when Java would run their initializers: as soon as one is
 * made, or something static of it is used. Names are internal ones.
 */
final class Beginnings {
    private static final String INITIALIZER = "<clinit>";

    private final ClassFiles files;
    private final Map<String, Optional<Facts>> known = new ConcurrentHashMap<>();

    /**
     * @param files all classes that are loaded once per brick
     */
    Beginnings(ClassFiles files) {
        this.files = files;
    }

    /**
     * What matters of a class.
     *
     * @param statics its static members, as names with descriptors
     * @param begins whether it has an initializer of its own
     */
    private record Facts(
            @Nullable String superclass, boolean isPublic, boolean begins, Set<String> statics) {
        static Facts of(byte[] classFile) {
            ClassNode node = new ClassNode();
            new ClassReader(classFile)
                    .accept(
                            node,
                            ClassReader.SKIP_CODE
                                    | ClassReader.SKIP_DEBUG
                                    | ClassReader.SKIP_FRAMES);
            Set<String> statics = new HashSet<>();
            boolean begins = false;
            for (MethodNode method : node.methods) {
                begins |= method.name.equals(INITIALIZER);
                if ((method.access & Opcodes.ACC_STATIC) != 0) {
                    statics.add(method.name + method.desc);
                }
            }
            for (FieldNode field : node.fields) {
                if ((field.access & Opcodes.ACC_STATIC) != 0) {
                    statics.add(field.name + field.desc);
                }
            }
            boolean isPublic = (node.access & Opcodes.ACC_PUBLIC) != 0;
            return new Facts(node.superName, isPublic, begins, statics);
        }
    }

    /**
     * The class whose beginning comes first when one of a type is made: the type, or the nearest
     * class above it that has an initializer; null if none has. That class sees to those above it.
     */
    @Nullable String ofMaking(@Nullable String type) {
        String each = type;
        while (each != null && facts(each).isPresent()) {
            Facts facts = facts(each).get();
            if (facts.begins()) {
                return each;
            }
            each = facts.superclass();
        }
        return null;
    }

    /** As {@link #ofMaking}, when a static member is used; null also where it lies elsewhere. */
    @Nullable String ofUsing(String owner, String member) {
        String each = owner;
        while (each != null && facts(each).isPresent()) {
            Facts facts = facts(each).get();
            if (facts.statics().contains(member)) {
                return ofMaking(each);
            }
            each = facts.superclass();
        }
        return null;
    }

    /** The same, for the superclass of a type. */
    @Nullable String above(String type) {
        return facts(type).map(Facts::superclass).map(this::ofMaking).orElse(null);
    }

    /** Whether code of a class runs only after another one has begun, as that is it or above it. */
    boolean hasBegunFor(String user, String begun) {
        String each = user;
        while (each != null && facts(each).isPresent()) {
            if (each.equals(begun)) {
                return true;
            }
            each = facts(each).get().superclass();
        }
        return false;
    }

    /** Whether code of a class may name another one. */
    boolean isSeenBy(String user, String type) {
        boolean isPublic = facts(type).map(Facts::isPublic).orElse(true);
        return isPublic || packageOf(user).equals(packageOf(type));
    }

    private static String packageOf(String type) {
        return type.substring(0, type.lastIndexOf('/') + 1);
    }

    /** Empty for a class of Java's own, or one that is missing. */
    private Optional<Facts> facts(String type) {
        return known.computeIfAbsent(
                type, name -> files.find(name.replace('/', '.')).map(Facts::of));
    }
}
