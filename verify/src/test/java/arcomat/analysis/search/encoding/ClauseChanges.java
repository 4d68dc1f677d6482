package arcomat.analysis.search.encoding;

import arcomat.analysis.refinement.ComparedSystems;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.product.Certificate;
import arcomat.analysis.search.product.Certificate.Entry;
import arcomat.analysis.search.product.Certificate.Form;
import arcomat.analysis.search.step.Steps;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.search.system.NetworkWords;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/** Clauses that are wrong, or may be, and what is met by trying everything. */
final class ClauseChanges {
    private static final String NOT = "not ";
    private static final int MOST_MET = 3_000;
    private static final int MOST_CHANGES = 12;

    private ClauseChanges() {}

    /** Without a clause, without one of its words, with the contrary or another one instead. */
    static List<Certificate> of(Certificate proof, List<Set<String>> met) {
        List<Certificate> all = new ArrayList<>();
        for (int i = 0; i < proof.entries().size() && i < MOST_CHANGES; i++) {
            List<Entry> rest = new ArrayList<>(proof.entries());
            List<String> cube = rest.remove(i).right();
            all.add(new Certificate(Form.CLAUSES, rest));
            for (int word = 0; word < cube.size(); word++) {
                all.add(with(rest, changed(cube, word, List.of())));
                all.add(with(rest, changed(cube, word, List.of(contrary(cube.get(word))))));
            }
        }
        for (int i = 0; i < met.size() && i < MOST_CHANGES; i++) {
            int which = i * met.size() / Math.min(met.size(), MOST_CHANGES);
            List<String> parts =
                    met.get(which).stream().filter(word -> word.contains(": ")).sorted().toList();
            all.add(with(proof.entries(), parts));
        }
        return all;
    }

    private static String contrary(String word) {
        return word.startsWith(NOT) ? word.substring(NOT.length()) : NOT + word;
    }

    private static List<String> changed(List<String> cube, int which, List<String> instead) {
        List<String> other = new ArrayList<>(cube);
        other.remove(which);
        other.addAll(which, instead);
        return other;
    }

    private static Certificate with(List<Entry> entries, List<String> never) {
        List<Entry> more = new ArrayList<>(entries);
        more.add(new Entry(Certificate.NEVER, never));
        return new Certificate(Form.CLAUSES, more);
    }

    /** Nothing, and all that is met nowhere: that one configuration is in one word of its own. */
    static List<Certificate> guesses(Promise left, Promise right, Budget budget) {
        List<Certificate> all = new ArrayList<>();
        all.add(new Certificate(Form.CLAUSES, List.of()));
        all.add(Certificate.ofClauses(List.of(List.of())));
        Set<String> words = new LinkedHashSet<>();
        List<Set<String>> met = met(left, right, budget);
        met.forEach(each -> each.stream().sorted().forEach(words::add));
        words.remove("");
        for (String word : words) {
            all.add(Certificate.ofClauses(List.of(List.of(word))));
            all.add(Certificate.ofClauses(List.of(List.of(NOT + word))));
        }
        return all;
    }

    /** Whether all is so; of words about the right side nothing is known. */
    static boolean isIn(Set<String> state, List<String> cube) {
        return cube.stream()
                .allMatch(
                        word ->
                                word.startsWith(NOT)
                                        ? !word.contains(" may be in ")
                                                && !state.contains(word.substring(NOT.length()))
                                        : state.contains(word));
    }

    /** What is so in configurations of the left side that are met while the right one follows. */
    static List<Set<String>> met(Promise left, Promise right, Budget budget) {
        if (!(ComparedSystems.of(left, right, budget).left() instanceof NetworkSystem network)
                || !network.canBePacked()) {
            return List.of();
        }
        NetworkSystem system = network.smaller().system();
        AllLetters letters = AllLetters.of(system);
        Set<Integer> seen = new LinkedHashSet<>();
        List<Integer> open = new ArrayList<>();
        add(system, system.openings(), seen, open);
        for (int i = 0; i < open.size() && open.size() < MOST_MET; i++) {
            int from = open.get(i);
            letters.each(
                    letter -> add(system, system.steps(from, letters.values(letter)), seen, open));
        }
        return open.stream().map(each -> words(system, system.state(each))).toList();
    }

    private static void add(
            NetworkSystem system, Steps steps, Set<Integer> seen, List<Integer> open) {
        IntStream.of(steps.next())
                .filter(next -> !system.state(next).isError())
                .filter(seen::add)
                .forEach(open::add);
    }

    private static Set<String> words(NetworkSystem system, GlobalState state) {
        NetworkWords words = system.words();
        Set<String> all = new HashSet<>();
        for (int part = 0; part < state.parts().size(); part++) {
            all.add(words.part(part, state.parts().get(part)));
        }
        for (int signal = 0; signal < state.registers().size(); signal++) {
            all.add(signal(words, signal, state));
        }
        return all;
    }

    /** Parts that are left out send nothing. */
    private static String signal(NetworkWords words, int signal, GlobalState state) {
        try {
            return words.signal(signal, state.registers().get(signal));
        } catch (IllegalArgumentException nobody) {
            return "";
        }
    }
}
