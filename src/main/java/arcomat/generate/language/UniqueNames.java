package arcomat.generate.language;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/** Identifiers that have to differ: who comes first keeps the name, others get an underscore. */
public final class UniqueNames {
    private final Set<String> taken;
    private final Map<String, Integer> tried = new HashMap<>();
    private final boolean ignoreCase;

    private UniqueNames(Set<String> taken, boolean ignoreCase) {
        this.taken = taken;
        this.ignoreCase = ignoreCase;
    }

    public static UniqueNames of(Set<String> reserved) {
        return new UniqueNames(new HashSet<>(reserved), false);
    }

    /** For names that become names of files: some file systems do not know case. */
    static UniqueNames ofFiles(Set<String> reserved) {
        UniqueNames scope = new UniqueNames(new HashSet<>(), true);
        reserved.forEach(word -> scope.taken.add(scope.key(word)));
        return scope;
    }

    /** The wanted name, or the first free one made from it. */
    public String claim(String wanted) {
        return claimAll(wanted);
    }

    /** Claims a name together with those made from it by the suffixes: all have to be free. */
    public String claimAll(String wanted, String... suffixes) {
        String name = wanted;
        while (isTaken(name, suffixes)) {
            int next = tried.merge(wanted, 1, Integer::sum);
            name = wanted + "_" + (next == 1 ? "" : String.valueOf(next));
        }
        taken.add(key(name));
        for (String suffix : suffixes) {
            taken.add(key(name + suffix));
        }
        return name;
    }

    private boolean isTaken(String name, String... suffixes) {
        boolean found = taken.contains(key(name));
        for (String suffix : suffixes) {
            found |= taken.contains(key(name + suffix));
        }
        return found;
    }

    private String key(String name) {
        return ignoreCase ? name.toLowerCase(Locale.ROOT) : name;
    }
}
