package arcomat.pipeline.guest;

import arcomat.check.LawBook;
import arcomat.check.guest.GuestLaws;
import arcomat.guest.host.Guests;
import arcomat.guest.host.Guests.Form;
import arcomat.guest.host.Guests.Kind;
import arcomat.guest.host.Guests.Language;
import arcomat.guest.host.Guests.Question;
import arcomat.guest.host.Guests.Reader;
import arcomat.pipeline.KeptFolder;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;

import java.io.IOException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;

/**
 * Lets guests in.
 *
 * @param paths of jars and of folders of classes, as the user wrote them
 */
public record WelcomeGuests(List<String> paths) implements Task<Guests> {
    /**
     * @throws WrongUse where there is no guest at a path, or one that cannot stay
     */
    @Override
    public Guests run(Session session) throws WrongUse {
        List<GuestLaws> laws = new ArrayList<>();
        List<Question> questions = new ArrayList<>();
        List<Language> languages = new ArrayList<>();
        List<Kind> kinds = new ArrayList<>();
        List<Reader> readers = new ArrayList<>();
        List<String> libraries = new ArrayList<>();
        List<Form> forms = new ArrayList<>();
        for (String path : paths) {
            for (GuestJar.Arrival each : GuestJar.open(path, session.names()).arrivals()) {
                laws.add(each.laws());
                questions.addAll(each.questions());
                languages.addAll(each.languages());
                kinds.addAll(each.kinds());
                readers.addAll(each.readers());
                if (!each.library().isEmpty()) {
                    libraries.add(written(each.library(), path));
                }
                forms.addAll(each.forms());
            }
        }
        requireDifferent(laws);
        requireWords(languages);
        requireKinds(kinds);
        requireEndings(readers);
        requireForms(forms);
        return new Guests(
                LawBook.of(laws), questions, languages, kinds, readers, libraries, forms, paths);
    }

    /** A model root that is read like any other. */
    private static String written(SortedMap<String, String> library, String path) throws WrongUse {
        try {
            return KeptFolder.written(KeptFolder.LIBRARY, library).toString();
        } catch (IOException e) {
            throw new WrongUse(
                    "the library of the guest '%s' cannot be written among temporary files: %s",
                    path, String.valueOf(e.getMessage()));
        }
    }

    /** Whose a name or a code is must be clear to whoever reads a finding or means it. */
    private static void requireDifferent(List<GuestLaws> guests) throws WrongUse {
        Map<String, String> owners = new HashMap<>();
        Map<String, GuestLaws> names = new HashMap<>();
        for (GuestLaws guest : guests) {
            if (names.put(guest.guest(), guest) != null) {
                throw new WrongUse(
                        "two guests have the name '%s'; leave one of them out", guest.guest());
            }
            for (String code : guest.codes()) {
                String other = owners.put(code, guest.guest());
                if (other != null) {
                    throw new WrongUse(
                            "the code %s is that of two findings, of guest '%s' and of guest '%s';"
                                    + " leave one of them out",
                            code, other, guest.guest());
                }
            }
        }
    }

    private static void requireWords(List<Language> languages) throws WrongUse {
        Map<String, Language> words = new HashMap<>();
        for (Language language : languages) {
            Language other = words.put(language.keyword(), language);
            if (other != null) {
                throw new WrongUse(
                        "behaviours that begin with '%s' are of two guests, '%s' and '%s'; leave"
                                + " one of them out",
                        language.keyword(), other.guest(), language.guest());
            }
        }
    }

    private static void requireEndings(List<Reader> readers) throws WrongUse {
        Map<String, Reader> endings = new HashMap<>();
        for (Reader reader : readers) {
            for (String ending : reader.endings()) {
                Reader other = endings.put(ending, reader);
                if (other != null) {
                    throw new WrongUse(
                            "files that end in '%s' are of two guests, '%s' and '%s'; leave one of"
                                    + " them out",
                            ending, other.guest(), reader.guest());
                }
            }
        }
    }

    private static void requireForms(List<Form> forms) throws WrongUse {
        Map<String, Form> names = new HashMap<>();
        for (Form form : forms) {
            Form other = names.put(form.name(), form);
            if (other != null) {
                throw new WrongUse(
                        "reports of the form '%s' are of two guests, '%s' and '%s'; leave one of"
                                + " them out",
                        form.name(), other.guest(), form.guest());
            }
        }
    }

    private static void requireKinds(List<Kind> kinds) throws WrongUse {
        Map<String, Kind> words = new HashMap<>();
        for (Kind kind : kinds) {
            Kind other = words.put(kind.word(), kind);
            if (other != null) {
                throw new WrongUse(
                        "models of kind '%s' are imported by two guests, '%s' and '%s'; leave one"
                                + " of them out",
                        kind.word(), other.guest(), kind.guest());
            }
        }
    }
}
