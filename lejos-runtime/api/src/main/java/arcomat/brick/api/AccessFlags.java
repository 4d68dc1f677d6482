package arcomat.brick.api;

import org.objectweb.asm.Opcodes;

import java.util.Map;

/** The words of the table for access flags. */
final class AccessFlags {
    private static final Map<String, Integer> FLAGS =
            Map.of(
                    "-", 0,
                    "public", Opcodes.ACC_PUBLIC,
                    "protected", Opcodes.ACC_PROTECTED,
                    "static", Opcodes.ACC_STATIC,
                    "final", Opcodes.ACC_FINAL,
                    "abstract", Opcodes.ACC_ABSTRACT,
                    "interface", Opcodes.ACC_INTERFACE,
                    "enum", Opcodes.ACC_ENUM,
                    // One bit, two meanings: the table spells it so for transient fields, too.
                    "varargs", Opcodes.ACC_VARARGS);

    private AccessFlags() {}

    static int parse(String words) {
        int flags = 0;
        for (String word : words.split(" ")) {
            Integer flag = FLAGS.get(word);
            if (flag == null) {
                throw new IllegalArgumentException("unknown access flag " + word);
            }
            flags |= flag;
        }
        return flags;
    }
}
