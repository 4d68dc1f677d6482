/**
 * Rows of a campaign as Apache Parquet, for programs that read tables. The only package that knows
 * the library; nobody loads it who keeps no table.
 */
package arcomat.pipeline.campaign.parquet;
