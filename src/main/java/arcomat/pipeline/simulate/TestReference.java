package arcomat.pipeline.simulate;

import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.source.Nearest;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.nio.file.Path;
import java.util.List;

/**
 * A test in a file, as {@code --input} names it.
 *
 * @param file as written
 * @param test the name of a test in it
 */
record TestReference(String file, String test, PathNames names) {
    static TestReference parse(String written, PathNames names) throws WrongUse {
        int mark = written.lastIndexOf('#');
        if (mark <= 0 || !written.substring(0, mark).endsWith(".mt")) {
            throw new WrongUse("--input '" + written + "' is not of the form FILE.mt#test");
        }
        return new TestReference(written.substring(0, mark), written.substring(mark + 1), names);
    }

    /** The test of a model that was loaded with the file. */
    StreamTest in(Model model) throws WrongUse {
        Path wanted = PathNames.real(names.resolve(file));
        List<StreamTest> suite =
                model.tests().stream()
                        .filter(t -> PathNames.real(placeOf(t)).equals(wanted))
                        .toList();
        List<String> tests = suite.stream().map(StreamTest::name).toList();
        return suite.stream()
                .filter(t -> t.name().equals(test))
                .findFirst()
                .orElseThrow(() -> new WrongUse(unknown(tests)));
    }

    /** What the suite of the file tests, by name. */
    List<ComponentSymbol> components(Workspace models) {
        Path wanted = PathNames.real(names.resolve(file));
        return models.testSuites().stream()
                .filter(s -> PathNames.real(names.resolve(s.unit().file().path())).equals(wanted))
                .flatMap(suite -> suite.component().found().stream())
                .toList();
    }

    private Path placeOf(StreamTest test) {
        return names.resolve(test.span().file().path());
    }

    private String unknown(List<String> tests) {
        if (tests.isEmpty()) {
            return "'" + file + "' holds no tests";
        }
        return "'%s' has no test '%s'%s; it has %s"
                .formatted(file, test, Nearest.hint(test, tests), String.join(", ", tests));
    }
}
