package arcomat.analysis.game;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.IntKey;
import arcomat.analysis.search.letter.Alphabet;
import arcomat.model.Value;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.IntStream;

/**
 * A single word of inputs after which no output complies, however the system has answered on the
 * way: the environment plays blind (a game of incomplete information: Reif, "The complexity of
 * two-player games of incomplete information", 1984). Breadth first over the sets of positions that
 * the system may have brought about; shortest words first, among those the fewest messages, then
 * declaration order.
 */
final class BlindStrategy {
    private static final int MOST_SETS = 50_000;

    /**
     * @param positions that the system may be in after the word so far, sorted
     * @param parent null at the beginning
     * @param letter that led here from the parent; null at the beginning
     */
    private record Node(
            @Nullable Node parent, Value @Nullable [] letter, int[] positions, int messages) {}

    private final Game game;
    private final Arena arena;
    private final Budget budget;
    private final AttractorRanks ranks;
    private final int longest;
    private @Nullable Node best;

    /**
     * @param ranks of the positions that have been explored
     * @param longest longer words are not looked for
     */
    BlindStrategy(Game game, AttractorRanks ranks, int longest, Budget budget) {
        this.game = game;
        this.ranks = ranks;
        this.longest = longest;
        this.arena = game.arena();
        this.budget = budget;
    }

    /**
     * @param word one array of messages per input; empty where no single word will do, or none was
     *     found in time
     * @param decided whether there is no word where none was found
     */
    record Found(Optional<List<Value[]>> word, boolean decided) {}

    Found search() {
        Node root = new Node(null, null, positions(arena.openings()), 0);
        if (root.positions.length == 0) {
            return new Found(Optional.of(List.of()), true);
        }
        List<Node> level = isHopeless(root.positions, 0) ? List.of() : List.of(root);
        Map<IntKey, Node> seen = new HashMap<>();
        for (int length = 1; !level.isEmpty(); length++) {
            List<Node> next = new ArrayList<>();
            Map<IntKey, Integer> atLevel = new HashMap<>();
            for (Node node : level) {
                if (seen.size() > MOST_SETS || budget.exhausted(seen.size()) != null) {
                    return new Found(Optional.empty(), false);
                }
                expand(node, length, seen, next, atLevel);
            }
            if (best != null) {
                return new Found(Optional.of(word(best)), true);
            }
            next.sort(Comparator.comparingInt(Node::messages));
            level = next;
        }
        return new Found(Optional.empty(), true);
    }

    private void expand(
            Node node,
            int length,
            Map<IntKey, Node> seen,
            List<Node> next,
            Map<IntKey, Integer> atLevel) {
        Alphabet alphabet = arena.alphabet(node.positions);
        for (int i : arena.different(alphabet, node.positions)) {
            Value[] letter = alphabet.letter(i);
            int messages = node.messages + alphabet.messages(i);
            TreeSet<Integer> after = new TreeSet<>();
            for (int position : node.positions) {
                for (int each : positions(arena.options(position, letter))) {
                    after.add(each);
                }
            }
            int[] set = after.stream().mapToInt(Integer::intValue).toArray();
            Node child = new Node(node, letter, set, messages);
            if (set.length == 0) {
                best = best == null || messages < best.messages ? child : best;
            } else if (!isHopeless(set, length)) {
                add(child, seen, next, atLevel);
            }
        }
    }

    private static void add(
            Node child, Map<IntKey, Node> seen, List<Node> next, Map<IntKey, Integer> atLevel) {
        IntKey key = new IntKey(child.positions);
        Integer place = atLevel.get(key);
        if (place != null && child.messages < next.get(place).messages) {
            next.set(place, child);
        } else if (place == null && !seen.containsKey(key)) {
            seen.put(key, child);
            atLevel.put(key, next.size());
            next.add(child);
        }
    }

    private static int[] positions(List<Arena.Option> options) {
        return options.stream().mapToInt(Arena.Option::position).sorted().distinct().toArray();
    }

    /** Where the system wins from one of the positions, or lasts too long, no word fits all. */
    private boolean isHopeless(int[] positions, int length) {
        return IntStream.of(positions).anyMatch(game::isWon)
                || longest != AttractorRanks.NEVER && ranks.of(positions) > longest - length;
    }

    private static List<Value[]> word(Node last) {
        LinkedList<Value[]> word = new LinkedList<>();
        for (Node node = last; node != null && node.letter != null; node = node.parent) {
            word.addFirst(node.letter);
        }
        return word;
    }
}
