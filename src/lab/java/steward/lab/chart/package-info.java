/** Pictures of measurements: colours for light and dark pages, wrapped text, files. */
package steward.lab.chart;
