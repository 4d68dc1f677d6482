package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.TypeContext;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;

/** How far an action has been read: what is known there, and where it goes on. */
final class Course {
    /** Where the statement behind the one that was read last stands. */
    enum Next {
        GO_ON,
        /** At the beginning of the next round of a loop. */
        AGAIN,
        /** Behind the loop. */
        BEHIND
    }

    /** Local variables that loops ask for, as the original calls them. */
    final Set<String> counting;

    Known known = Known.NOTHING;

    /** Of local variables, as the original calls them. */
    Map<String, TypeContext> types = Map.of();

    Next next = Next.GO_ON;

    /** Whether 'break' and 'continue' have a loop that they are sure to go on with. */
    boolean isInRound;

    boolean isInLoop;

    /** Of all loops so far. */
    int rounds;

    /** What counts, and stays as it is in a branch of which nobody knows whether it is taken. */
    Set<String> fixed = Set.of();

    /** Names of local variables, as they are written. */
    Set<String> declared = new HashSet<>();

    Course(Set<String> counting) {
        this.counting = Set.copyOf(counting);
    }

    void declare(String variable, TypeContext type) {
        Map<String, TypeContext> more = new HashMap<>(types);
        more.put(variable, type);
        types = Map.copyOf(more);
    }

    /** What is read in a block: what it declares is forgotten behind it. */
    List<Deed> inBlock(Supplier<List<Deed>> block) {
        Set<String> names = new HashSet<>(declared);
        List<Deed> deeds = inRound(block);
        declared = names;
        return deeds;
    }

    /** The same without braces: names that are written in a round are not written anew. */
    List<Deed> inRound(Supplier<List<Deed>> round) {
        Known outer = known;
        Map<String, TypeContext> before = types;
        List<Deed> deeds = round.get();
        known = known.of(outer);
        types = before;
        return deeds;
    }
}
