package arcomat.pipeline.guest;

import arcomat.guest.SituatedLanguage;
import arcomat.guest.Vicinity;
import arcomat.guest.host.Guests.Language;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.symbols.signatures.Signature;
import arcomat.translate.VicinityView;
import arcomat.tree.Behaviour;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.WeakHashMap;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Has a guest say what behaviours mean where they stand. In an editor the same text is asked about
 * at every letter that is written elsewhere: the answer is kept as long as the text is, so that a
 * slow guest is waited for once.
 */
final class SituatedBehaviours implements BehaviourReader {
    private final List<Language> languages;
    private final Map<Behaviour.Foreign, Map<Vicinity, Reading>> known =
            Collections.synchronizedMap(new WeakHashMap<>());

    private SituatedBehaviours(List<Language> languages) {
        this.languages = languages;
    }

    /**
     * @param languages of one guest
     */
    static BehaviourReader in(List<Language> languages) {
        List<Language> situated =
                languages.stream()
                        .filter(each -> each.translator() instanceof SituatedLanguage)
                        .toList();
        return situated.isEmpty() ? NONE : new SituatedBehaviours(situated);
    }

    @Override
    public Optional<Reading> read(Behaviour.Foreign behaviour, Signature around) {
        return languages.stream()
                .filter(each -> each.keyword().equals(behaviour.keyword().text()))
                .findFirst()
                .map(language -> read(behaviour, language, VicinityView.of(around)));
    }

    /** Not inside of the map's own lock: one guest would keep the others waiting. */
    private Reading read(Behaviour.Foreign behaviour, Language language, Vicinity around) {
        Map<Vicinity, Reading> ofText =
                known.computeIfAbsent(behaviour, any -> new ConcurrentHashMap<>());
        Reading before = ofText.get(around);
        if (before != null) {
            return before;
        }
        SituatedLanguage translator = (SituatedLanguage) language.translator();
        Reading now =
                new BehaviourTranslation(behaviour, language)
                        .ask((text, meaning) -> translator.translate(text, around, meaning), false)
                        .reading();
        ofText.put(around, now);
        return now;
    }
}
