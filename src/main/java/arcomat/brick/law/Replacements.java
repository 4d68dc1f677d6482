package arcomat.brick.law;

import arcomat.brick.jar.Hierarchy;
import arcomat.brick.jar.JavaNames;
import arcomat.brick.jar.ReferenceSearch.Reference;

import java.util.List;
import java.util.Map;

/** What to write instead of the things that are missed most. */
final class Replacements {
    private static final String NOTHING = "do without it";

    private static final Map<String, String> TYPES =
            Map.ofEntries(
                    Map.entry("java/util/TreeMap", "use java.util.HashMap"),
                    Map.entry("java/util/LinkedHashMap", "use java.util.HashMap"),
                    Map.entry("java/util/EnumMap", "use an array indexed by ordinal()"),
                    Map.entry("java/util/TreeSet", "use java.util.HashSet"),
                    Map.entry("java/util/EnumSet", "use an array indexed by ordinal()"),
                    Map.entry("java/util/ArrayDeque", "use java.util.Queue or an array"),
                    Map.entry("java/util/Scanner", "use java.io.BufferedReader"),
                    Map.entry(
                            "java/util/Objects",
                            "where it is not in your text, the compiler put it there: compile for"
                                    + " Java 6 against the brick's classes"));

    private static final Map<String, String> MEMBERS =
            Map.ofEntries(
                    Map.entry("java/lang/String.format", "join texts by +"),
                    Map.entry("java/lang/String.contains", "use indexOf(text) >= 0"),
                    Map.entry("java/lang/String.split", "use java.util.StringTokenizer"),
                    Map.entry("java/io/PrintStream.printf", "join texts by + and print them"),
                    Map.entry("java/lang/Class.getName", "write the name as a text"),
                    Map.entry("java/lang/Class.getSimpleName", "write the name as a text"));

    private Replacements() {}

    static String ofType(String name) {
        return TYPES.getOrDefault(name, NOTHING);
    }

    /** Advice, or the methods of the same name that do exist. */
    static String ofMember(Hierarchy hierarchy, String owner, Reference.Member member) {
        String advice = MEMBERS.get(owner + "." + member.name());
        if (advice != null) {
            return advice;
        }
        List<String> others =
                hierarchy
                        .methodsOfTheBrick(owner, member.name())
                        .map(other -> JavaNames.method(owner, other.name(), other.descriptor()))
                        .distinct()
                        .toList();
        return others.isEmpty() ? NOTHING : "it has " + String.join(", ", others);
    }
}
