package arcomat.pipeline.campaign.engine;

import arcomat.sim.load.LineProbe;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Where the programs of a campaign come to what its runs may cover.
 *
 * @param transitions how many of the numbers are those of transitions: the first ones
 * @param programs those that were made of models, by what worlds say of them; of each the lines
 *     that are reached exactly where something is covered
 */
public record ItemProbes(int transitions, Map<String, List<LineProbe>> programs) {
    /** Of programs without models. */
    public static final ItemProbes NONE = new ItemProbes(0, Map.of());

    public ItemProbes {
        programs = Map.copyOf(programs);
    }

    /** None for a program that was given as a jar. */
    List<LineProbe> of(String program) {
        return programs.getOrDefault(program, List.of());
    }

    /** Whether it is known what a program covers. */
    boolean knows(String program) {
        return programs.containsKey(program);
    }

    /** What {@link #read} reads: a line for each probe of a program. */
    static String text(List<LineProbe> probes) {
        return probes.stream()
                .map(each -> each.type() + " " + each.line() + " " + each.number() + "\n")
                .collect(Collectors.joining());
    }

    /**
     * @throws IOException where it is not the text of probes
     */
    static List<LineProbe> read(String text) throws IOException {
        List<LineProbe> probes = new ArrayList<>();
        for (String line : text.lines().toList()) {
            String[] words = line.split(" ", -1);
            if (words.length != 3) {
                throw new IOException("a probe of " + words.length + " words");
            }
            probes.add(new LineProbe(words[0], number(words[1]), number(words[2])));
        }
        return probes;
    }

    static int number(String word) throws IOException {
        try {
            return Integer.parseUnsignedInt(word);
        } catch (NumberFormatException e) {
            throw new IOException(e);
        }
    }

    /** Probes in the order of programs, however they came. */
    Map<String, List<LineProbe>> ordered() {
        return new TreeMap<>(programs);
    }
}
