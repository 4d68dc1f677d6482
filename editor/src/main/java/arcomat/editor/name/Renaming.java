package arcomat.editor.name;

import arcomat.editor.desk.View;
import arcomat.guest.host.Guests;
import arcomat.pipeline.check.LibraryFolder;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.SourceFile;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Referent;
import arcomat.syntax.Identifiers;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;

/** Gives something another name, so that models mean what they meant, or says why not. */
public final class Renaming {
    private Renaming() {}

    /**
     * What is under a cursor.
     *
     * @throws RenameRefused where nothing is there, or what cannot be renamed to whatever name
     */
    public static Occurrence target(View view, int offset) throws RenameRefused {
        Optional<Occurrence> found = Mentions.at(view, offset);
        if (found.isEmpty()) {
            throw new RenameRefused("there is no name here that is known");
        }
        refuseForeign(view.models(), found.get().referent());
        return found.get();
    }

    /**
     * @param models checked
     * @param goOn asked now and then; it may throw what ends the work
     * @throws RenameRefused where the name is none, or where models would mean something else
     */
    public static RenamePlan plan(OpenModels models, Referent referent, String name, Runnable goOn)
            throws RenameRefused {
        Optional<String> problem = Identifiers.problem(name);
        if (problem.isPresent()) {
            throw new RenameRefused(problem.get());
        }
        Map<Referent, String> names = RenamedTogether.of(models.workspace(), referent, name);
        for (Referent each : names.keySet()) {
            refuseForeign(models, each);
            refuseUnread(models, each);
        }
        RenamePlan plan = RenamePlan.of(models, names);
        refuseForeignTexts(models, plan);
        OpenModels after = plan.applied(models).check(goOn);
        Optional<String> obstacle = RenameCheck.obstacle(plan, models, after);
        if (obstacle.isPresent()) {
            throw new RenameRefused(
                    "'%s' cannot be renamed to '%s': %s"
                            .formatted(referent.name(), name, obstacle.get()));
        }
        return plan;
    }

    private static void refuseForeign(OpenModels models, Referent referent) throws RenameRefused {
        Optional<SourceFile> file = referent.declaration().map(place -> place.file());
        if (referent.kind() == Referent.Kind.PACKAGE) {
            throw new RenameRefused(
                    "'%s' is a package; move its folder, and correct the 'package' lines"
                            .formatted(referent.name()));
        }
        if (file.isEmpty()) {
            throw new RenameRefused("'%s' is built in".formatted(referent.name()));
        }
        String path = file.get().path();
        Optional<Guests.Reader> reader = models.guests().reader(path);
        if (reader.isPresent()) {
            throw new RenameRefused(
                    "'%s' comes from '%s', a text of guest '%s', who alone knows how it is written; rename it there by hand"
                            .formatted(referent.name(), path, reader.get().guest()));
        }
        Path place = models.root().resolve(path);
        if (models.libraries().holds(place)) {
            throw new RenameRefused(
                    "'%s' belongs to a library, which is only read here: '%s'"
                            .formatted(referent.name(), place.getFileName()));
        }
        if (models.isLibrary(path) || LibraryFolder.holds(place)) {
            throw new RenameRefused(
                    "'%s' belongs to the library that comes with the tool"
                            .formatted(referent.name()));
        }
    }

    /** What else a word says in a guest's language, nobody else knows. */
    private static void refuseForeignTexts(OpenModels models, RenamePlan plan)
            throws RenameRefused {
        for (String path : plan.edits().keySet()) {
            Optional<Guests.Reader> reader = models.guests().reader(path);
            if (reader.isPresent()) {
                throw new RenameRefused(
                        "'%s' stands in '%s', a text of guest '%s', who alone knows how it is written; rename it by hand"
                                .formatted(
                                        String.join(
                                                "', '",
                                                plan.names().keySet().stream()
                                                        .map(Referent::name)
                                                        .distinct()
                                                        .toList()),
                                        path,
                                        reader.get().guest()));
            }
        }
    }

    /** Where a text has syntax errors, not everything that is named in it is known. */
    private static void refuseUnread(OpenModels models, Referent referent) throws RenameRefused {
        Optional<String> unread =
                Mentions.withWord(models, referent.name())
                        .filter(path -> models.parsed(path).orElseThrow().unit().isEmpty())
                        .findFirst();
        if (unread.isPresent()) {
            throw new RenameRefused(
                    "'%s' stands in '%s', which has syntax errors; correct them first"
                            .formatted(referent.name(), unread.get()));
        }
    }
}
