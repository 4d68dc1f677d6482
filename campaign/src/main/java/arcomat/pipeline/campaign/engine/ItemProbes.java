package arcomat.pipeline.campaign.engine;

import arcomat.sim.load.NotedLines;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Where the programs of a campaign come to what its runs may cover.
 *
 * @param transitions how many of the numbers are those of transitions: the first ones
 * @param programs those that were made of models, by what worlds say of them
 */
public record ItemProbes(int transitions, Map<String, ProgramItems> programs) {
    /** Of programs without models. */
    public static final ItemProbes NONE = new ItemProbes(0, Map.of());

    public ItemProbes {
        programs = Map.copyOf(programs);
    }

    /** What objects of a program are to note: nothing for one that was given as a jar. */
    List<NotedLines> lines(String program) {
        return of(program).map(ProgramItems::lines).orElse(List.of());
    }

    /** Empty where nobody knows what a program covers. */
    Optional<ProgramItems> of(String program) {
        return Optional.ofNullable(programs.get(program));
    }

    static int number(String word) throws IOException {
        try {
            return Integer.parseUnsignedInt(word);
        } catch (NumberFormatException e) {
            throw new IOException(e);
        }
    }

    /** In the order of programs, however they came. */
    Map<String, ProgramItems> ordered() {
        return new TreeMap<>(programs);
    }
}
