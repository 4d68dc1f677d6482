package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.external.ExternalPairs;
import arcomat.analysis.search.packed.PairStore;
import arcomat.analysis.search.packed.RandomEventNetworks;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.UncheckedIOException;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;

/**
 * A search whose pairs are elsewhere says what one in memory says, word by word: with room for very
 * few pairs, and however often it is interrupted and begun again.
 */
class ExternalPairsTest {
    private static final int QUESTIONS = Integer.getInteger("packed.questions", 60);
    private static final int SEED = Integer.getInteger("packed.seed", 19);
    private static final int MOST_BEGINNINGS = 1_000;
    private static final int CELLS = 12;
    private static final int FEW = 8;

    /** Elsewhere, a pair is met although there is one with a smaller set. */
    private static final Set<Shortcut> RULES =
            EnumSet.of(Shortcut.SYMBOLIC, Shortcut.MET_ALONE, Shortcut.MET_SMALLER);

    private static final Budget BUDGET =
            new Budget(() -> false, 5_000).with(rule -> !RULES.contains(rule));

    private final Map<Answer, Integer> stored = new EnumMap<>(Answer.class);
    private final Random random = new Random(SEED);
    private int resumed;
    private int interrupted;
    private long blocks;

    @Tag("slow")
    @Test
    void saysTheSameOfNetworks() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            compare(question.left(), question.right(), question.text());
        }
        requireEnough();
    }

    /**
     * What is left of the time is for counting configurations, too: whoever has none gets the
     * answer without.
     */
    @Tag("slow")
    @Test
    void countsNoLongerThanItMay() {
        RandomNetworks networks = new RandomNetworks(SEED);
        int answered = 0;
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            Verdict inMemory = Refinement.compare(question.left(), question.right(), BUDGET);
            if (inMemory.answer() != Answer.UNKNOWN) {
                answered += answeredUncounted(question, inMemory) ? 1 : 0;
            }
        }
        assertThat(answered).isGreaterThan(QUESTIONS / 30);
    }

    /** With more and more patience, until it is enough for all. */
    private static boolean answeredUncounted(RandomNetworks.Question question, Verdict inMemory) {
        boolean answered = false;
        Verdict verdict = Verdict.unknown("");
        for (int patience = 1; !verdict.equals(inMemory); patience += 1 + patience / 2) {
            Budget budget = BUDGET.patient(patience);
            verdict = ask(question.left(), question.right(), budget, new Attempts(), FEW);
            if (verdict.answer() == inMemory.answer()) {
                answered |= verdict.explored().left().isEmpty();
                assertThat(verdict.trace()).isEqualTo(inMemory.trace());
            } else {
                assertThat(verdict.answer()).isEqualTo(Answer.UNKNOWN);
            }
        }
        return answered;
    }

    @Tag("slow")
    @Test
    void saysTheSameOfRows() {
        for (int i = 0; i < QUESTIONS / 4; i++) {
            RandomRows rows = new RandomRows(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Any"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Several"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
        }
        requireEnough();
    }

    @Tag("slow")
    @Test
    void saysTheSameOfEvents() {
        for (int i = 0; i < QUESTIONS; i++) {
            RandomEventNetworks networks = new RandomEventNetworks(SEED + i);
            for (String right : List.of("Any", "Some", "Strict")) {
                compare(networks.promise("Whole"), networks.promise(right), networks.toString());
            }
        }
        requireEnough();
    }

    /** Each cell keeps a message for a slice, or none: there are 4096 pairs in 13 levels. */
    @Tag("slow")
    @Test
    void saysTheSameOfManyPairs() {
        Model model =
                ReadModels.model(
                        file("Cell", CELL),
                        file("Row", row()),
                        file("Any", ANY),
                        file("Silent", SILENT));
        Promise row = promise(model, "Row");
        for (int i = 0; i < QUESTIONS / 15; i++) {
            compare(row, promise(model, "Any"), "a row of cells");
            compare(row, promise(model, "Silent"), "a row of cells that is to send nothing");
        }
        assertThat(stored.get(Answer.HOLDS)).isEqualTo(QUESTIONS / 15);
        assertThat(stored.get(Answer.FAILS)).isEqualTo(QUESTIONS / 15);
        assertThat(blocks).isGreaterThan(100 * QUESTIONS);
    }

    private static SourceFile file(String name, String text) {
        return new SourceFile("r/" + name + ".arc", "package r;\n" + text);
    }

    private static Promise promise(Model model, String name) {
        return Promise.of(model.component("r." + name).orElseThrow(), List.of());
    }

    private static final String CELL =
            """
            component Cell {
                port in Integer[0..1] x, out Integer[0..1] o;
                <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s [x == 1] / {o = 1};
                }
            }
            """;

    private static final String ANY =
            """
            component Any {
                port in Integer[0..1] x, out Integer[0..1] o;
                <<completion = "output">> automaton {
                    state s;
                    initial s;
                }
            }
            """;

    private static final String SILENT =
            """
            component Silent {
                port in Integer[0..1] x, out Integer[0..1] o;
                <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s / {};
                }
            }
            """;

    private static String row() {
        StringBuilder text = new StringBuilder("component Row {\n");
        text.append("port in Integer[0..1] x, out Integer[0..1] o;\n");
        for (int cell = 0; cell < CELLS; cell++) {
            String before = cell == 0 ? "x" : "c" + (cell - 1) + ".o";
            text.append(
                    "component Cell c%d;\nconnect %s -> c%d.x;\n".formatted(cell, before, cell));
        }
        return text + "connect c%d.o -> o;\n}\n".formatted(CELLS - 1);
    }

    private void requireEnough() {
        assertThat(stored.get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(stored.get(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
        assertThat(resumed).isGreaterThan(QUESTIONS / 10);
        assertThat(interrupted).isGreaterThan(QUESTIONS / 10);
    }

    private void compare(Promise left, Promise right, String text) {
        Verdict inMemory = Refinement.compare(left, right, BUDGET);
        if (inMemory.answer() == Answer.UNKNOWN) {
            return;
        }
        Attempts memory = new Attempts();
        int capacity = 1 + random.nextInt(1 << random.nextInt(8));
        String described = "capacity " + capacity + " of\n" + text;
        Verdict elsewhere = ask(left, right, BUDGET, memory, capacity);
        assertThat(elsewhere).as(described).isEqualTo(inMemory);
        if (memory.commits() == 0) {
            return;
        }
        stored.merge(inMemory.answer(), 1, Integer::sum);
        blocks += memory.written();
        Verdict again = ask(left, right, BUDGET, memory.afterwards(), capacity);
        assertThat(again).as("again, " + described).isEqualTo(inMemory);
        Verdict interruptedly = interrupted(left, right, capacity);
        assertThat(interruptedly).as("interrupted, " + described).isEqualTo(inMemory);
    }

    /** Killed in the middle of what is written, or told that the time is up, and begun again. */
    private Verdict interrupted(Promise left, Promise right, int capacity) {
        Attempts memory = new Attempts();
        String last = "";
        for (int patience = 1; patience < MOST_BEGINNINGS; patience++) {
            memory = memory.afterwards();
            resumed += memory.isBegun() ? 1 : 0;
            boolean kill = random.nextBoolean();
            memory.failAfter(kill ? random.nextInt(4 * patience) : Long.MAX_VALUE);
            Budget ended = kill ? BUDGET : BUDGET.patient(random.nextInt(30 * patience * patience));
            try {
                Verdict verdict = ask(left, right, ended, memory, capacity);
                boolean counted = verdict.explored().left().isPresent();
                if (verdict.answer() != Answer.UNKNOWN && counted) {
                    return verdict;
                }
                last = verdict.reason();
                interrupted++;
            } catch (UncheckedIOException killed) {
                assertThat(killed).hasMessageContaining(BlocksInMemory.KILLED);
                interrupted++;
            }
        }
        throw new AssertionError("no end in sight, " + last);
    }

    private static Verdict ask(
            Promise left, Promise right, Budget budget, Attempts memory, int capacity) {
        Iterator<BlocksInMemory> attempts = memory.attempts().iterator();
        PairStore.Maker maker =
                (network, layout) ->
                        new ExternalPairs(
                                network, layout, attempts.next(), capacity, budget::insist);
        return Refinement.compare(left, right, budget, Optional.of(maker));
    }

    /** A question may be asked of a smaller network first, and then of the whole. */
    private record Attempts(List<BlocksInMemory> attempts) {
        Attempts() {
            this(List.of(new BlocksInMemory(), new BlocksInMemory()));
        }

        Attempts afterwards() {
            return new Attempts(attempts.stream().map(BlocksInMemory::afterwards).toList());
        }

        void failAfter(long operations) {
            attempts.forEach(each -> each.failAfter(operations));
        }

        int commits() {
            return attempts.stream().mapToInt(each -> each.commits).sum();
        }

        int written() {
            return attempts.stream().mapToInt(each -> each.written).sum();
        }

        boolean isBegun() {
            return attempts.stream().anyMatch(each -> each.notes().isPresent());
        }
    }
}
