#pragma once

namespace cdr::measure {

/// How often each of two sides was chosen in a two-alternative forced choice.
struct ChoiceCounts {
    unsigned left = 0;
    unsigned right = 0;

    unsigned all() const { return left + right; }
};

/// One-sample chi-squared of the counts against an even split, one degree of freedom (thesis Table 6.9):
/// (left - right)^2 / (left + right). base::InputError when nobody chose, or over a million chose
/// one side.
double chiSquared(const ChoiceCounts& counts);

/// How likely a chi-squared with one degree of freedom is to be at least this large by chance: the upper
/// tail, erfc(sqrt(x / 2)).
/// @param chiSquared at least 0.
double chiSquaredTail(double chiSquared);

/// Exact two-sided binomial p against an even split. It is the probability of counts at least this uneven when
/// every choice is a toss of a fair coin. It holds for few trials, where chi-squared's curve does not.
/// base::InputError as chiSquared().
double binomialTail(const ChoiceCounts& counts);

} // namespace cdr::measure
