package arcomat.pipeline.generate;

import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedModels;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

/**
 * The code that those have who are responsible for the libraries of a session: what is generated of
 * the libraries alone. What nobody but their user can have made, such as a generic component of
 * theirs with messages of his, is not among it.
 *
 * @param texts by their paths
 */
record LibraryCode(Map<String, String> texts) {
    private static final LibraryCode NONE = new LibraryCode(Map.of());

    /**
     * Makes it, as they have made it; none where that fails, for then they have none either.
     *
     * @throws WrongUse where code written by hand cannot be read
     */
    static LibraryCode of(Target target, Choosing choosing, Session session) throws WrongUse {
        List<String> libraries = new ArrayList<>(session.libraries());
        libraries.removeAll(
                session.guests().libraries()); // guests bring models, and no code of them
        if (libraries.isEmpty()) {
            return NONE;
        }
        Session alone = session.with(List.of());
        CheckedModels models = CheckedModels.checkWithoutTests(libraries, alone);
        if (models.hasErrors()) {
            return NONE;
        }
        PathNames names = session.names();
        Implementations implementations =
                Implementations.find(target, models.loaded().roots(names), names);
        Request all = Request.all(models.lower(alone).model(), choosing);
        Generation generation = Generator.generate(all.with(implementations.texts()), target);
        return new LibraryCode(implementations.with(generation));
    }

    /** Leaves out what is the same; what has another text here is needed here. */
    void leaveOutOf(Map<String, byte[]> output) {
        texts.forEach(
                (path, text) -> {
                    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
                    if (Arrays.equals(output.get(path), bytes)) {
                        output.remove(path);
                    }
                });
    }
}
