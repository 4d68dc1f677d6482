package arcomat.analysis.smt;

import arcomat.analysis.smt.MessageExamples.Rows;
import arcomat.analysis.smt.Remainders.Reading;
import arcomat.model.Port;
import arcomat.semantics.expression.PartialEvaluation;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;

/**
 * Examples of messages for all letters of a search. Letters that leave the same open have the same
 * examples, wherever they are read; so what is left of facts is numbered, and asked about once.
 */
public final class KnownExamples {
    private record Question(List<Port> ports, IntArrayList facts) {}

    private final BooleanSupplier stop;
    private final Map<DataFact, Integer> numbers = new HashMap<>();
    private final List<DataFact> facts = new ArrayList<>();
    private final BitSet open = new BitSet();
    private final Map<Question, Rows> known = new HashMap<>();

    /**
     * @param stop asked now and then, whether to give up; for good, once it says so
     */
    public KnownExamples(BooleanSupplier stop) {
        this.stop = stop;
    }

    /** Of letters that some steps tell apart. */
    public MessageExamples.Source of(List<DataStep> steps) {
        List<DataFact> all = DataStep.facts(steps);
        List<Group> groups = groups(all);
        return (letter, ports) -> {
            int[] left = new int[all.size()];
            groups.forEach(group -> group.copyTo(left, letter));
            return known.computeIfAbsent(
                    new Question(ports, open(left)),
                    question -> MessageExamples.of(ports, facts(question), stop));
        };
    }

    private List<Group> groups(List<DataFact> all) {
        Remainders remainders = new Remainders();
        Map<Reading, Group> groups = new LinkedHashMap<>();
        for (int i = 0; i < all.size(); i++) {
            groups.computeIfAbsent(
                            Reading.of(all.get(i).expressions()),
                            reading -> new Group(reading, remainders))
                    .add(i, all.get(i));
        }
        return List.copyOf(groups.values());
    }

    /** Those of which something is open, each once. */
    private IntArrayList open(int[] left) {
        IntArrayList chosen = new IntArrayList();
        BitSet seen = new BitSet();
        for (int fact : left) {
            if (open.get(fact) && !seen.get(fact)) {
                seen.set(fact);
                chosen.add(fact);
            }
        }
        return chosen;
    }

    private List<DataFact> facts(Question question) {
        return IntStream.of(question.facts.toArray()).mapToObj(facts::get).toList();
    }

    private int number(DataFact fact) {
        return numbers.computeIfAbsent(
                fact,
                each -> {
                    open.set(facts.size(), each.isOpen());
                    facts.add(each);
                    return facts.size() - 1;
                });
    }

    /** Facts that read the same ports: of letters that agree there, the same is left of them. */
    private final class Group {
        private final Reading reading;
        private final Remainders remainders;
        private final IntArrayList positions = new IntArrayList();
        private final List<DataFact> members = new ArrayList<>();
        private final Map<Object, int[]> left = new HashMap<>();

        Group(Reading reading, Remainders remainders) {
            this.reading = reading;
            this.remainders = remainders;
        }

        void add(int position, DataFact fact) {
            positions.add(position);
            members.add(fact);
        }

        /**
         * @param all written to at the positions of the facts
         */
        void copyTo(int[] all, PartialEvaluation letter) {
            int[] mine = left.computeIfAbsent(reading.knowledge(letter), each -> left(letter));
            for (int i = 0; i < mine.length; i++) {
                all[positions.get(i)] = mine[i];
            }
        }

        private int[] left(PartialEvaluation letter) {
            return members.stream()
                    .mapToInt(fact -> number(fact.with(e -> remainders.of(e, letter))))
                    .toArray();
        }
    }
}
