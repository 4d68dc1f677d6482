package arcomat.cluster.hazelcast;

import arcomat.pipeline.campaign.engine.Freight;

import com.hazelcast.collection.IQueue;
import com.hazelcast.core.HazelcastInstance;
import com.hazelcast.map.IMap;

import java.util.Optional;
import java.util.UUID;

/**
 * What the campaign and its workers share: a notice of which campaign there is, a box for letters,
 * and a queue of trials for each worker. The names of box and queues hold what tells the campaign
 * from every other one, and this course of it from others: what a worker of another one may still
 * have to say goes nowhere.
 *
 * @param notice which campaign there is, in words that every version can read
 * @param goods the campaign's freight
 */
record Board(HazelcastInstance hazelcast, IMap<String, String> notice, IMap<String, byte[]> goods) {
    private static final String VERSION = "version";
    private static final String CAMPAIGN = "campaign";
    private static final String COURSE = "course";

    static Board of(HazelcastInstance hazelcast) {
        return new Board(hazelcast, hazelcast.getMap("notice"), hazelcast.getMap("goods"));
    }

    /**
     * @param version of the tool that makes the campaign
     * @param campaign the hash of its freight
     * @param course of this process
     */
    record Notice(String version, String campaign, String course) {}

    /** The version comes first: what else there is may be another version's. */
    Notice post(Freight freight) {
        Notice posted = new Notice(freight.version(), freight.hash(), UUID.randomUUID().toString());
        goods.put(posted.campaign(), freight.packed());
        notice.put(VERSION, posted.version());
        notice.put(CAMPAIGN, posted.campaign());
        notice.put(COURSE, posted.course());
        return posted;
    }

    /** What was posted; none yet where a campaign has only just begun. */
    Optional<Notice> read() {
        String course = notice.get(COURSE);
        String version = notice.get(VERSION);
        String campaign = notice.get(CAMPAIGN);
        return course == null || version == null || campaign == null
                ? Optional.empty()
                : Optional.of(new Notice(version, campaign, course));
    }

    /** Letters of workers. */
    IQueue<byte[]> letters(Notice of) {
        return hazelcast.getQueue("letters " + of.campaign() + " " + of.course());
    }

    /** Trials for a worker. */
    IQueue<byte[]> trials(Notice of, UUID worker) {
        return hazelcast.getQueue("trials " + of.campaign() + " " + of.course() + " " + worker);
    }
}
