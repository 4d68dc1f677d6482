package arcomat.pipeline.campaign.watch;

import arcomat.generate.CodeLayout;
import arcomat.sim.load.Program;
import arcomat.world.Kind;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * The programs of all runs of a campaign, by what its worlds say of them.
 *
 * @param named what they say
 * @param robots the programs that each robot may have, by its name
 * @param programs those that could be had
 * @param layouts where those that were made of models have what these have
 */
public record CampaignCode(
        Map<String, Kind.Program> named,
        Map<String, Set<String>> robots,
        Map<String, Program> programs,
        Map<String, CodeLayout> layouts) {
    /** The same with some programs in the place of others. */
    CampaignCode with(Map<String, Program> others, Map<String, CodeLayout> theirs) {
        Map<String, Program> all = new TreeMap<>(programs);
        all.putAll(others);
        Map<String, CodeLayout> places = new TreeMap<>(layouts);
        places.putAll(theirs);
        return new CampaignCode(named, robots, all, places);
    }
}
